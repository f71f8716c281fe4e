// What this engine does differently is in its caveats (sources: github.com/liabru/matter-js, src/ of 0.20.0: Body.js,
// Resolver.js, Constraint.js). Besides:
// - It computes in pixels and milliseconds. Its own gravity, 1000 px/s^2, is the earth's where a metre is 100 px.
// - No capsules, no segments. No half-spaces: we build them from a box as large as the scene can reach.
// - Damping takes a part of both velocities. We make it e^(-c dt), which needs the same c for both.
// - What a pull on a joint turns leaves out its arm (resistanceTotal in Constraint.js adds 1/m and 1/I), and a rod
//   hinged at its end spins up without bound: we join centres of mass only. Stiffness has no unit, so that there are no
//   springs. No sliding joints, welds and limits.
// - We mix the coefficients and set them on each pair when it begins; bodies that a joint connects are sensors for each
//   other.
// - It caches impulses of slow contacts only, so that we report no contacts.
import Matter from 'matter-js';
import { NotSupported, centered, corners, mixed, plus, serve, turned } from './plumb_engine.mjs';

const { Bodies, Body, Composite, Constraint, Engine, Events, Vertices } = Matter;
const BASE = 1000 / 60; // ms, of the engine's unit of velocity
const GRAVITY = 10;     // m/s^2, to which the error of a joint is stated

class World {
  constructor(scene, options) {
    this.scale = Number(options.scale);
    this.engine = Engine.create({ gravity: { scale: 0 }, velocityIterations: Number(options.velocity),
                                  positionIterations: Number(options.position),
                                  constraintIterations: Number(options.constraint) });
    this.scene = scene;
    this.bodies = scene.bodies.map((body) => this.add(body));
    const joined = scene.joints.map(({ bodies }) => [...bodies].sort().join());
    for (const joint of scene.joints) this.join(joint);
    Events.on(this.engine, 'collisionStart', ({ pairs }) => pairs.forEach((pair) => {
      const [a, b] = [pair.bodyA.plugin, pair.bodyB.plugin];
      if (joined.includes([a.owner, b.owner].sort().join())) pair.isSensor = true;
      for (const key of ['friction', 'restitution']) { // the pair would take them from its bodies in each step
        const value = mixed[scene.mixing[key]](a[key], b[key]);
        Object.defineProperty(pair, key, { get: () => value, set: () => {} });
      }
    }));
  }

  px([x, y]) {
    return { x: x * this.scale, y: y * this.scale };
  }

  add(body) {
    if (body.linearDamping !== body.angularDamping) throw new NotSupported('has one damping for both velocities');
    const outside = body.shapes.map((shape) => this.part(shape, body));
    const isStatic = body.type !== 'dynamic';
    const inertia = body.fixedRotation ? Infinity : body.inertia * this.scale ** 2;
    const made = outside.length === 1 ? outside[0] : Body.create({ parts: outside });
    Body.setCentre(made, this.px(body.position));
    if (isStatic) Body.setStatic(made, true);
    else Object.assign(made, { mass: body.mass, inverseMass: 1 / body.mass, inertia, inverseInertia: 1 / inertia });
    const speed = BASE / 1000;
    Body.setVelocity(made, this.px(body.velocity.map((part) => part * speed)));
    Body.setAngularVelocity(made, body.angularVelocity * speed);
    Composite.add(this.engine.world, made);
    return made;
  }

  // A body of one shape, already turned: bodies start at angle 0.
  part(shape, { index, position, angle, layers }) {
    const plugin = { owner: index, friction: shape.friction, restitution: shape.restitution };
    const options = { plugin, frictionAir: 0, collisionFilter: { category: layers, mask: layers } };
    const place = (point) => this.px(plus(turned(point, angle), position));
    if (shape.type === 'circle') {
      const { x, y } = place(shape.center);
      return Bodies.circle(x, y, shape.radius * this.scale, options);
    }
    let polygon = shape;
    if (shape.type === 'halfspace') {
      const [nx, ny] = shape.normal;
      const { extent } = this.scene;
      const center = [nx, ny].map((part) => part * (shape.offset - extent / 2));
      polygon = { size: [4 * extent, extent], center, angle: Math.atan2(-nx, ny) };
    } else if (shape.type === 'capsule' || shape.type === 'segment') {
      throw new NotSupported(`has no ${shape.type}s, only polygons`);
    }
    const vertices = corners(polygon).map(place);
    return Body.create({ position: Vertices.centre(vertices), vertices, ...options });
  }

  join(joint) {
    if (joint.limits) throw new NotSupported('has no limits of joints');
    if (joint.motor) throw new NotSupported('has no motors');
    if (joint.stiffness) throw new NotSupported('has a stiffness without unit, and so no springs in N/m');
    if (joint.type === 'prismatic') throw new NotSupported('has no sliding joints');
    if (joint.type === 'weld') throw new NotSupported('has no welds');
    const [a, b] = joint.bodies;
    const arm = (i, k) => {
      const { type, position } = this.scene.bodies[i];
      const made = plus(joint.anchors?.[k] ?? joint.anchor, position, -1);
      if (type === 'dynamic' && Math.hypot(...made) > 1e-6) {
        throw new NotSupported('leaves out the arms of joints: it joins centres of mass only');
      }
      return this.px(made);
    };
    Composite.add(this.engine.world, Constraint.create({
      bodyA: this.bodies[a], bodyB: this.bodies[b], pointA: arm(a, 0), pointB: arm(b, 1), stiffness: 1,
      length: (joint.length ?? 0) * this.scale }));
  }

  drive(body, velocity) {
    this.scene.bodies[body].velocity = velocity;
  }

  step(dt) {
    const loads = this.scene.loads?.(this.states());
    const unit = this.scale / 1e6; // px/ms^2 in m/s^2
    this.scene.bodies.forEach(({ type, mass, gravityScale, linearDamping, velocity, angularVelocity }, i) => {
      const body = this.bodies[i];
      if (type === 'dynamic') {
        const [x, y, torque] = loads?.[i] ?? [0, 0, 0];
        body.force.x += (this.scene.gravity[0] * gravityScale * mass + x) * unit;
        body.force.y += (this.scene.gravity[1] * gravityScale * mass + y) * unit;
        body.torque += torque * unit * this.scale;
        body.frictionAir = ((1 - Math.exp(-linearDamping * dt)) * BASE) / (dt * 1000);
      } else if (type === 'kinematic') {
        const { x, y } = body.position;
        Body.setPosition(body, { x: x + velocity[0] * this.scale * dt, y: y + velocity[1] * this.scale * dt }, true);
        Body.setAngle(body, body.angle + angularVelocity * dt, true);
      }
    });
    Engine.update(this.engine, dt * 1000);
  }

  states() {
    return this.scene.bodies.map(({ type, angle, velocity, angularVelocity }, i) => {
      const body = this.bodies[i];
      const { x, y } = Body.getVelocity(body);
      const speed = 1000 / BASE / this.scale;
      const moving = type === 'dynamic' ? [x * speed, y * speed, Body.getAngularVelocity(body) * (1000 / BASE)]
                                        : [...velocity, angularVelocity];
      return [body.position.x / this.scale, body.position.y / this.scale, angle + body.angle, ...moving];
    });
  }

  free() {
    Engine.clear(this.engine);
  }
}

// The slop is what Body.slop leaves alone and, of what a body falls into another in a step, the tenth that each
// iteration leaves (Resolver._positionDampen); the threshold is Resolver._restingThresh. A joint falls for one step
// before it is pulled back. Contacts have no order that its author states.
function stepping({ scale, velocity, position }, dt) {
  const fall = GRAVITY * dt * dt;
  return { arithmetic: 'double', drift: 0.5, order: 1, slop: 0.05 / scale + fall * 0.1 ** position, jointSlop: fall,
           differencedVelocities: true, restitutionThreshold: (2 / scale) * (1000 / BASE), iterations: Number(velocity),
           positionIterations: Number(position), springLimit: 2 };
}

const count = (key, value, about, ladder) => ({ key, value, about, min: 1, max: 10000, whole: true, ladder });
serve({
  name: 'matter', version: Matter.version,
  about: 'matter.js: Verlet, positions corrected apart from velocities, double',
  source: 'matter-js, Liam Brummitt, brm.io/matter-js',
  caveats: [
    'its constants are lengths in pixels: results depend on how many are a metre (option scale)',
    'friction is no Coulomb law: sliding loses mu px a step whatever the load, and sticks below a speed set by the overlap',
    'overlap is removed from positions alone, down to 0.05 px',
    'nothing bounces below a closing speed of 2 px a sixtieth of a second',
    'discs are polygons of 26 sides',
    'joints are positions pulled together, between centres of mass only',
    'no continuous collision: fast bodies pass through thin ones, and bullet has no effect',
    'it reports no contacts',
  ],
  options: [
    count('velocity', '4', 'iterations of the velocity solver', ['2', '4', '8']),
    count('position', '6', 'iterations of the position solver'),
    count('constraint', '2', 'iterations of the joints'),
    { key: 'scale', value: '100', about: 'px, a metre', min: 1, max: 10000 },
  ],
}, stepping, (scene, masses, options) => new World(centered(scene, masses), options));
