// What this engine does differently is in its caveats (sources: github.com/erincatto/box2d at 3a4f0da, which this package
// is built from: physics_world.c, contact_solver.c, solver.c). Besides:
// - Each step is split into 4 sub-steps (option `substeps`) of symplectic Euler. Forces are held over a step.
// - Collisions are found once a step, a little ahead. Continuous collision against fixed bodies.
// - We count whole turns.
// - No half-spaces: we build them from a segment, in a frame along it, so that float errors are errors along it.
// - Contact impulses are the last sub-step's times the number of sub-steps. The package's totalNormalImpulse counts
//   those before and after relaxing both: twice the weight at rest.
import { b2, direct, listed, memory, refresh } from './embind.mjs';
import { NotSupported, centered, corners, mixed, moved, onOff, plus, serve, tuned, turned, unwound,
         writeContact } from './plumb_engine.mjs';

const GRAVITY = 10; // m/s^2, to which what a body sinks in is stated

const answer = b2._malloc(64); // where functions called directly write to
const at = answer >> 2;

// Handles on the engine's memory are given back as soon as they are read.
const using = (handle, read) => {
  const value = read(handle);
  handle.delete();
  return value;
};
// In words (box2d/types.h, box2d/collision.h): b2ContactData is a contact's id, two shapes' ids, whose first word is
// their index, and a b2Manifold: the normal, a rolling impulse, two points and their count. A b2ManifoldPoint is a
// point, its arms from A and B, separation, normal, tangent and total impulse, normal velocity and an id.
const SHAPE_A = 3, SHAPE_B = 5, NORMAL = 7, POINTS = 10, POINT = 12, COUNT = POINTS + 2 * POINT;
const ARM = 2, SEPARATION = 6, NORMAL_IMPULSE = 7, TANGENT_IMPULSE = 8;

const vector = ([x, y]) => new b2.b2Vec2(x, y);
const turn = (rotation, angle) => Object.assign(rotation, { c: Math.cos(angle), s: Math.sin(angle) });

class World {
  constructor(scene, options) {
    this.substeps = Number(options.substeps);
    this.world = using(b2.b2DefaultWorldDef(), (def) => {
      def.gravity.Set(...scene.gravity);
      def.restitutionThreshold = Number(options.restitution);
      def.enableSleep = options.sleep === 'on';
      def.enableContinuous = options.continuous === 'on';
      return b2.b2CreateWorld(def);
    });
    b2.b2World_EnableWarmStarting(this.world, options.warm === 'on');
    const { friction, restitution } = scene.mixing; // the engine's own rules are geometric and max
    if (friction !== 'geometric') b2.b2World_SetFrictionCallback(this.world, (a, _, b) => mixed[friction](a, b));
    if (restitution !== 'max') b2.b2World_SetRestitutionCallback(this.world, (a, _, b) => mixed[restitution](a, b));
    this.loads = scene.loads;
    this.read = scene.bodies.map(({ angle }) => [0, 0, angle, 0, 0, 0]);
    this.rows = []; // of contacts
    this.sinceRead = 0;
    this.owners = new Map(); // of the engine's shapes
    this.moving = scene.bodies.map(({ type }) => type !== 'static');
    try {
      this.bodies = scene.bodies.map((body) => this.add(body, scene.extent));
      this.ids = this.bodies.map(idOf);
      for (const joint of scene.joints) this.join(joint, scene.bodies);
    } catch (error) {
      this.free();
      throw error;
    }
  }

  add(body, extent) {
    const made = this.make(body, body.angle);
    for (const shape of body.shapes) {
      const slope = shape.type === 'halfspace' ? Math.atan2(-shape.normal[0], shape.normal[1]) : null;
      const carrier = slope === null ? made : this.make(body, body.angle + slope);
      using(b2.b2DefaultShapeDef(), (def) => {
        def.material.friction = shape.friction;
        def.material.restitution = shape.restitution;
        def.filter.categoryBits = def.filter.maskBits = body.layers >>> 0;
        this.owners.set(attach[shape.type](carrier, def, shape, extent).index1, body.index);
      });
    }
    if (body.type === 'dynamic') {
      using(new b2.b2MassData(), (data) => {
        data.center.Set(0, 0);
        b2.b2Body_SetMassData(made, Object.assign(data, { mass: body.mass, rotationalInertia: body.inertia }));
      });
      // Shapes shift the centre of mass, and the velocity with it; without that, fast bodies would not be seen as such.
      using(vector(body.velocity), (velocity) => b2.b2Body_SetLinearVelocity(made, velocity));
    }
    return made;
  }

  make(body, angle) {
    return using(b2.b2DefaultBodyDef(), (def) => {
      def.type = b2.b2BodyType[`b2_${body.type}Body`];
      def.position.Set(...body.position);
      turn(def.rotation, angle);
      def.linearVelocity.Set(...body.velocity);
      def.motionLocks.angularZ = body.fixedRotation;
      const { angularVelocity, linearDamping, angularDamping, gravityScale, bullet } = body;
      Object.assign(def, { angularVelocity, linearDamping, angularDamping, gravityScale, isBullet: bullet });
      return b2.b2CreateBody(this.world, def);
    });
  }

  join(joint, bodies) {
    const ends = joint.bodies.map((i) => bodies[i]);
    const kind = joint.type[0].toUpperCase() + joint.type.slice(1);
    using(b2[`b2Default${kind}JointDef`](), (def) => {
      const along = joint.axis ? Math.atan2(joint.axis[1], joint.axis[0]) : 0;
      ['A', 'B'].forEach((side, k) => {
        const frame = def.base[`localFrame${side}`];
        const arm = plus(joint.anchors?.[k] ?? joint.anchor, ends[k].position, -1);
        frame.p.Set(...turned(arm, -ends[k].angle));
        turn(frame.q, along - ends[k].angle);
        def.base[`bodyId${side}`] = this.bodies[joint.bodies[k]];
      });
      const unit = joint.type === 'revolute' ? 'Angle' : 'Translation';
      if (joint.limits) {
        const [low, high] = joint.limits;
        Object.assign(def, { enableLimit: true, [`lower${unit}`]: low, [`upper${unit}`]: high });
      }
      if (joint.motor) {
        const { speed: motorSpeed, strength } = joint.motor;
        Object.assign(def, { enableMotor: true, motorSpeed,
                             [joint.type === 'revolute' ? 'maxMotorTorque' : 'maxMotorForce']: strength });
      }
      if (joint.length) def.length = joint.length;
      if (joint.stiffness) {
        const { hertz, ratio } = tuned(joint, ends);
        Object.assign(def, { enableSpring: true, hertz, dampingRatio: ratio });
      }
      b2[`b2Create${kind}Joint`](this.world, def);
    });
  }

  drive(body, velocity) {
    using(vector(velocity), (now) => b2.b2Body_SetLinearVelocity(this.bodies[body], now));
  }

  step(dt) {
    if (this.loads) this.exert(dt);
    b2.b2World_Step(this.world, dt, this.substeps);
    this.sinceRead += dt;
  }

  exert(dt) {
    const ahead = ((1 - 1 / this.substeps) / 2) * dt; // where the sub-steps begin on average, as if each had its own
    this.loads(moved(this.states(), ahead)).forEach(([x, y, torque], i) => {
      using(vector([x, y]), (force) => b2.b2Body_ApplyForceToCenter(this.bodies[i], force, true));
      b2.b2Body_ApplyTorque(this.bodies[i], torque, true);
    });
  }

  states() {
    refresh();
    const { floats } = memory;
    this.ids.forEach((id, i) => {
      if (!this.moving[i] && this.sinceRead) return;
      const state = this.read[i]; // written anew: new ones would be garbage after each step
      state[5] = direct.b2Body_GetAngularVelocity(id);
      direct.b2Body_GetTransform(answer, id);
      state[0] = floats[at];
      state[1] = floats[at + 1];
      state[2] = unwound(Math.atan2(floats[at + 3], floats[at + 2]), state[2] + state[5] * this.sinceRead);
      direct.b2Body_GetLinearVelocity(answer, id);
      state[3] = floats[at];
      state[4] = floats[at + 1];
    });
    this.sinceRead = 0;
    return this.read;
  }

  contacts() { // where the bodies were read last
    const ends = []; // of each body's contacts among all
    const contacts = listed((soFar) => this.ids.forEach((id, i) => {
      const capacity = this.moving[i] ? direct.b2Body_GetContactCapacity(id) : 0;
      if (capacity) direct.b2Body_GetContactData(answer, id, capacity);
      ends.push(soFar.length);
    }));
    let i = 0;
    let count = 0;
    contacts.forEach((address, k) => {
      while (k >= ends[i]) ++i;
      const contact = address >> 2;
      const one = this.owners.get(memory.words[contact + SHAPE_A]);
      const other = this.owners.get(memory.words[contact + SHAPE_B]);
      // Two moving bodies both list it: it is told from its first.
      if (one === i || !this.moving[one]) count = this.tell(contact, one, other, count);
      b2._free(address);
    });
    this.rows.length = count;
    return this.rows;
  }

  tell(contact, one, other, count) {
    const [x, y] = this.read[one];
    const { words, floats } = memory;
    for (let i = 0, point = contact + POINTS; i < words[contact + COUNT]; ++i, point += POINT) {
      writeContact(this.rows, count++, one, other, x + floats[point + ARM], y + floats[point + ARM + 1],
                   floats[contact + NORMAL], floats[contact + NORMAL + 1], this.substeps * floats[point + NORMAL_IMPULSE],
                   -this.substeps * floats[point + TANGENT_IMPULSE], // its tangent is the normal turned by -90 degrees
                   floats[point + SEPARATION]);
    }
    return count;
  }

  free() {
    b2.b2DestroyWorld(this.world);
    this.ids?.forEach(b2._free);
  }
}

// The address of a body's id, which has an index and two numbers of two bytes.
function idOf({ index1, world0, generation }) {
  const address = b2._malloc(8);
  refresh();
  memory.words[address >> 2] = index1;
  memory.words[(address >> 2) + 1] = world0 | (generation << 16);
  return address;
}

const attach = {
  circle: (body, def, { center, radius }) => using(new b2.b2Circle(), (made) => {
    made.center.Set(...center);
    made.radius = radius;
    return b2.b2CreateCircleShape(body, def, made);
  }),
  box: (body, def, { size: [w, h], center, angle = 0 }) => using(vector(center), (middle) =>
    using(turn(b2.b2MakeRot(0), angle), (rotation) =>
      using(b2.b2MakeOffsetBox(w / 2, h / 2, middle, rotation), (made) => b2.b2CreatePolygonShape(body, def, made)))),
  polygon: (body, def, shape) => {
    const points = corners(shape);
    if (points.length > 8) throw new NotSupported('polygons have at most eight vertices');
    const vectors = points.map(vector);
    const made = using(b2.b2ComputeHull(vectors), (hull) => {
      if (hull.count < points.length) throw new NotSupported('drops vertices within 0.01 m of a line through others');
      return using(b2.b2MakePolygon(hull, 0), (made) => b2.b2CreatePolygonShape(body, def, made));
    });
    vectors.forEach((point) => point.delete());
    return made;
  },
  capsule: (body, def, { from, to, radius }) => using(new b2.b2Capsule(), (made) => {
    made.center1.Set(...from);
    made.center2.Set(...to);
    made.radius = radius;
    return b2.b2CreateCapsuleShape(body, def, made);
  }),
  segment: (body, def, { from, to }) => using(new b2.b2Segment(), (made) => {
    made.point1.Set(...from);
    made.point2.Set(...to);
    return b2.b2CreateSegmentShape(body, def, made);
  }),
  halfspace: (body, def, { offset }, extent) =>
    attach.segment(body, def, { from: [extent, offset], to: [-extent, offset] }),
};

// Contacts are springs of the lesser of 30 Hz and an eighth of the sub-step's rate, twice that on fixed bodies. The slop
// is their depth under one weight, 2.5 g/w^2 for a square on its like (two corners, each with half the weight and an
// effective mass of m/5); that of joints likewise, at twice that frequency. Impacts bounce at the end of the step that
// finds them, and its last relaxation brakes what would touch within a sub-step more. A contact keeps its points on both
// bodies for a step. With k = w dt and V = v dt a force that is held over n sub-steps makes V' = V - k^2 y, x' = x + V -
// (1 + 1/n)/2 k^2 y. At y = x a spring would gain energy; at y = x + (1 - 1/n)/2 V the determinant is 1 and the trace 2 -
// k^2.
function stepping({ substeps, restitution }, dt) {
  const h = dt / Number(substeps);
  const contact = Math.min(30, 0.125 / h);
  const joint = 2 * contact;
  const sink = (hertz) => (2.5 * GRAVITY) / (2 * Math.PI * hertz) ** 2;
  return { arithmetic: 'float', substep: h, drift: 0.5, order: 1, impactLag: 2 * Number(substeps), impactLead: 1,
           slop: sink(contact), contactFrequency: contact, fixedContactFrequency: 2 * contact,
           jointSlop: sink(joint), jointFrequency: joint, heldAnchors: true,
           tangentRotation: true, iterations: 1,
           restitutionThreshold: Number(restitution), wholeImpulses: false, springLimit: 2 };
}

serve({
  name: 'box2d3', version: '5.2.0', language: 'C', execution: 'WebAssembly',
  about: 'Box2D 3: soft contacts in sub-steps, float',
  source: 'Box2D 3.2 before its release (3a4f0da), Erin Catto, box2d.org; box2d3-wasm by Alex Birch and Erik Sombroek',
  caveats: [
    'float arithmetic',
    'contacts are damped springs of at most 30 Hz, 60 Hz on fixed bodies: they do not converge with the step',
    'nothing bounces below a closing speed of 1 m/s (option restitution)',
    'restitution acts once, at the end of the step, without friction, which takes mu m v from an impact that slips only',
    'rotations advance by atan(w h): fast spins lose some of their angle',
    'damping c divides velocities by 1 + c h each sub-step; the scene means e^(-c h)',
    'nothing moves faster than 400 m/s or turns by more than an eighth turn in a sub-step',
    'joints are springs of at most 60 Hz; soft ones are tuned by frequency, a stiffness only between centres of mass',
    'vertices within 0.01 m of a line through others are dropped; polygons have at most eight',
    'sleeping is off by default',
  ],
  options: [
    { key: 'substeps', value: '4', about: 'sub-steps of a step', min: 1, max: 1000, whole: true,
      ladder: ['1', '2', '4', '8'] },
    { key: 'restitution', value: '1', about: 'm/s, closing speed below which nothing bounces', min: 0, max: 100 },
    onOff('continuous', 'on', 'continuous collision', 'stops bodies at fixed ones within a step', 'bodies may overlap'),
    onOff('sleep', 'off', 'sleeping', 'stops bodies that hardly move', 'bodies never sleep'),
    onOff('warm', 'on', 'warm starting', "starts from the last step's impulses", 'starts from zero'),
  ],
}, stepping, (scene, masses, options) => new World(centered(scene, masses), options));
