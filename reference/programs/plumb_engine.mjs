// plumb-engine 1 for Node 18: the lines between Plumb and an engine, and what adapters share. Give serve() yours.

/** Throw it with the reason if the engine can't run a scene. */
export class NotSupported extends Error {}

const write = process.stdout.write.bind(process.stdout);
process.stdout.write = process.stderr.write.bind(process.stderr); // what the engine prints is its log

/**
 * Answers Plumb until it says end.
 * @param hello     object: name, version, and if you like about, source, language and execution (of what steps), caveats,
 *                  options
 * @param stepping  (options, dt) => object of what the engine states of its steps; see engine.schema.json
 * @param build     (scene, masses, options) => a world with
 *                  step(dt)    advances by dt seconds; the only call that is timed
 *                  states()    [x, y, angle, vx, vy, angular velocity] for each body, of its centre of mass
 *                  contacts()  optional, after states(): [a, b, x, y, normal x, normal y, normal impulse, tangent impulse, separation]
 *                  drive(body, [vx, vy])  optional: gives a kinematic body another velocity; without it there are no paths
 *                  free()      optional: gives back what the world holds
 */
export function serve(hello, stepping, build) {
  let world;
  let carry; // takes bodies along their paths, before a step
  let steps = 0; // since the build
  let text = '';
  let flushed = Date.now();
  const flush = () => (text && write(text), (text = ''), (flushed = Date.now()));
  const answer = (value) => say(JSON.stringify(value));
  const say = (line) => {
    text += line + '\n';
    if (text.length > 32768 || Date.now() - flushed > 50) flush(); // many answers in one write, none held back for long
  };
  const step = (dt) => {
    const began = performance.now();
    carry(dt);
    world.step(dt);
    const ns = Math.round((performance.now() - began) * 1e6);
    const states = packed(world.states(), 6);
    const contacts = world.contacts ? `,"contacts":"${packed(world.contacts(), 9)}"` : '';
    say(`{"step":${++steps},"ns":${ns},"states":"${states}"${contacts}}`);
  };
  const asked = {
    hello: () => answer({ 'plumb-engine': 1, language: 'JavaScript', execution: 'JIT', ...hello }),
    stepping: ({ options, dt }) => answer({ stepping: stepping(options, dt) }),
    build: ({ scene, masses, options }) => {
      world?.free?.();
      world = undefined;
      steps = 0;
      try {
        world = build(scene, masses, options);
        carry = carriage(scene, world);
        answer({ states: world.states() });
      } catch (error) {
        if (!(error instanceof NotSupported)) throw error;
        answer({ notSupported: error.message });
      }
    },
    step: ({ count, dt }) => Array.from({ length: count }, () => step(dt)),
    end: () => process.exit(0),
  };
  let rest = '';
  process.stdin.setEncoding('utf8').on('data', (chunk) => {
    const lines = (rest + chunk).split('\n');
    rest = lines.pop();
    try {
      for (const [[what, how]] of lines.map((line) => Object.entries(JSON.parse(line)))) {
        if (asked[what]) asked[what](how);
        else answer({ error: `unknown ask: ${what}` });
      }
    } catch (error) {
      answer({ error: `${error}`.slice(0, 400) });
      process.exitCode = 1;
      process.stdin.destroy();
      console.error(error);
    }
    flush();
  }).on('end', () => process.exit(0)); // or threads of an engine would outlive Plumb
}

/** Drives kinematic bodies along their paths: before a step of dt they get the velocity that takes them where they should
 *  be after it. */
function carriage({ bodies }, world) {
  const carried = bodies.map((body, index) => ({ ...body, index })).filter(({ path }) => path);
  if (carried.length && !world.drive) throw new NotSupported('has no paths of kinematic bodies');
  const turn = ({ frequency, phase = 0 }, t) => 2 * Math.PI * frequency * t + phase;
  const drive = ({ index, velocity = [0, 0], path }, rate) => world.drive(index, plus(velocity, path.amplitude, rate));
  carried.forEach((body) => drive(body, 2 * Math.PI * body.path.frequency * Math.cos(turn(body.path, 0))));
  let time = 0;
  return (dt) => {
    for (const body of carried) {
      drive(body, (Math.sin(turn(body.path, time + dt)) - Math.sin(turn(body.path, time))) / dt);
    }
    time += dt;
  };
}

let numbers = new Float64Array(1024);
let bytes = Buffer.from(numbers.buffer);

/** Rows of numbers in base64: thirty times as fast as their digits. */
function packed(rows, width) {
  const count = rows.length * width;
  if (count > numbers.length) {
    numbers = new Float64Array(2 * count);
    bytes = Buffer.from(numbers.buffer);
  }
  let next = 0;
  for (const row of rows) {
    if (row.length !== width) throw new Error(`${row.length} numbers, should be ${width}`);
    for (let k = 0; k < width; ++k) numbers[next++] = row[k];
  }
  return bytes.toString('base64', 0, 8 * count);
}

/** Writes a contact as row k, over that of an earlier step: new rows would be garbage after each step. */
export function writeContact(rows, k, a, b, x, y, normalX, normalY, normalImpulse, tangentImpulse, separation) {
  const row = (rows[k] ??= new Array(9).fill(0));
  row[0] = a;
  row[1] = b;
  row[2] = x;
  row[3] = y;
  row[4] = normalX;
  row[5] = normalY;
  row[6] = normalImpulse;
  row[7] = tangentImpulse;
  row[8] = separation;
}

/** An option that is on or off. */
export const onOff = (key, value, about, on, off) =>
  ({ key, value, about, choices: [{ value: 'on', about: on }, { value: 'off', about: off }] });

export const mixed = {
  geometric: (a, b) => Math.sqrt(a * b), pythagorean: (a, b) => Math.sqrt(a * a + b * b),
  average: (a, b) => (a + b) / 2, multiply: (a, b) => a * b, min: Math.min, max: Math.max };

export const plus = ([ax, ay], [bx, by], factor = 1) => [ax + factor * bx, ay + factor * by];
export const turned = ([x, y], angle) => [Math.cos(angle) * x - Math.sin(angle) * y,
                                          Math.sin(angle) * x + Math.cos(angle) * y];

/** The states that velocities lead to in that many seconds. */
export const moved = (states, ahead) => states.map(([x, y, angle, vx, vy, w]) =>
  [x + ahead * vx, y + ahead * vy, angle + ahead * w, vx, vy, w]);

/** The angle that is nearest to an expected one, for engines that keep angles within half a turn. */
export const unwound = (angle, expected) => angle + 2 * Math.PI * Math.round((expected - angle) / (2 * Math.PI));

/** The corners of a box or polygon, counter-clockwise. */
export function corners({ vertices, size: [w, h] = [0, 0], center, angle = 0 }) {
  const signs = [[-1, -1], [1, -1], [1, 1], [-1, 1]];
  const points = vertices ?? signs.map(([x, y]) => plus(turned([(x * w) / 2, (y * h) / 2], angle), center));
  const area = points.reduce((sum, [x, y], i) => sum + points.at(i - 1)[0] * y - points.at(i - 1)[1] * x, 0);
  return area < 0 ? [...points].reverse() : points;
}

/** Stiffness k and damping d of a soft distance joint as frequency and damping ratio: k = m w^2 and d = 2 z m w for the
 *  effective mass m along the line between two centres of mass. */
export function tuned({ stiffness, damping = 0, anchors }, ends) {
  const arm = ({ position }, k) => Math.hypot(...plus(anchors[k], position, -1));
  if (ends.some((body, k) => body.type === 'dynamic' && arm(body, k) > 1e-6)) {
    throw new NotSupported('tunes springs by frequency: soft distance joints between centres of mass only');
  }
  const inverse = ends.reduce((sum, { mass }) => sum + (mass && 1 / mass), 0);
  const w = Math.sqrt(stiffness * inverse);
  return { hertz: w / (2 * Math.PI), ratio: (damping * inverse) / (2 * w) };
}

/** The scene with its defaults, bodies and shapes about their centres of mass, joints' bodies as indices, and
 *  extent   m, within which everything stays that gravity and its first velocity alone move
 *  loads    states => [force x, force y, torque] for each body, of all forces but gravity; null if there are none */
export function centered(scene, masses) {
  const index = Object.fromEntries(scene.bodies.map(({ name }, i) => [name, i]));
  const bodies = scene.bodies.map((given, i) => {
    const [mass, inertia, ...center] = masses[i];
    if (given.type === 'dynamic' && !mass) throw new NotSupported(`cannot move "${given.name}", which has no mass`);
    return { angle: 0, velocity: [0, 0], angularVelocity: 0, gravityScale: 1, linearDamping: 0, angularDamping: 0,
             fixedRotation: false, bullet: false, layers: ~0, ...given, index: i, mass, inertia, center,
             position: plus(given.position, turned(center, given.angle ?? 0)),
             shapes: given.shapes.map((shape) => shifted(shape, center, given)) };
  });
  const reach = ({ position, velocity, gravityScale }) => Math.hypot(...position) + scene.duration *
    (Math.hypot(...velocity) + (Math.abs(gravityScale) * Math.hypot(...scene.gravity) * scene.duration) / 2);
  const joints = (scene.joints ?? []).map((joint) => ({ ...joint, bodies: joint.bodies.map((name) => index[name]) }));
  return { ...scene, bodies, joints, mixing: { friction: 'geometric', restitution: 'max', ...scene.mixing },
           extent: Math.max(100, ...bodies.map(reach)), loads: loadsOf(scene.forces ?? [], bodies, index) };
}

function shifted(shape, center, { type, name }) {
  const from = (point) => point && plus(point, center, -1);
  if (shape.friction?.static !== shape.friction?.dynamic) {
    throw new NotSupported(`has one coefficient of friction, but static and dynamic friction of "${name}" differ`);
  }
  if (shape.type === 'halfspace' && type === 'dynamic') throw new NotSupported(`cannot move the half-space "${name}"`);
  const [nx, ny] = shape.normal ?? [0, 0];
  return { restitution: 0, ...shape, friction: shape.friction?.dynamic ?? shape.friction ?? 0,
           center: from(shape.center ?? [0, 0]), from: from(shape.from), to: from(shape.to),
           vertices: shape.vertices?.map(from), offset: shape.offset - nx * center[0] - ny * center[1] };
}

function loadsOf(forces, bodies, index) {
  const add = (load, force, arm = [0, 0], factor = 1) => [force[0], force[1], arm[0] * force[1] - arm[1] * force[0]]
    .forEach((part, k) => (load[k] += factor * part));
  const kinds = {
    constant: ({ body, force, torque = 0 }) => (_, loads) => [...force, torque].forEach((part, k) =>
      (loads[index[body]][k] += part)),
    attraction: ({ from, strength, exponent = 2, mutual }) => (states, loads) => bodies.forEach(({ mass }, i) => {
      const d = plus(states[index[from]], states[i], -1);
      const r = Math.hypot(...d);
      if (i === index[from] || !mass || !r) return;
      const force = d.map((part) => (part / r) * mass * strength * r ** -exponent);
      add(loads[i], force);
      if (mutual) add(loads[index[from]], force, [0, 0], -1);
    }),
    spring: (spring) => (states, loads) => {
      const end = (name, local) => {
        const [x, y, angle, vx, vy, w] = states[index[name]];
        const arm = turned(plus(local, bodies[index[name]].center, -1), angle);
        const velocity = [vx - w * arm[1], vy + w * arm[0]];
        return { load: loads[index[name]], arm, point: plus([x, y], arm), velocity };
      };
      const [a, b] = spring.bodies?.map((name, k) => end(name, spring.anchors[k])) ??
        [{ point: spring.anchor, velocity: [0, 0] }, end(spring.body, spring.bodyAnchor ?? [0, 0])];
      const d = plus(b.point, a.point, -1);
      const distance = Math.hypot(...d);
      if (!distance) return;
      const u = d.map((part) => part / distance);
      const speed = plus(b.velocity, a.velocity, -1);
      const pull = spring.stiffness * (distance - spring.length) +
        (spring.damping ?? 0) * (u[0] * speed[0] + u[1] * speed[1]);
      if (a.load) add(a.load, u, a.arm, pull);
      add(b.load, u, b.arm, -pull);
    },
  };
  const all = forces.map((force) => kinds[force.type](force));
  if (!all.length) return null;
  return (states) => {
    const loads = states.map(() => [0, 0, 0]);
    all.forEach((exert) => exert(states, loads));
    return loads;
  };
}
