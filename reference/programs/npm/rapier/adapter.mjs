// What this engine does differently is in its caveats (sources: github.com/dimforge/rapier, src/dynamics, of version 0.35:
// integration_parameters.rs, rigid_body_components.rs). Besides:
// - Each step is split into 4 sub-steps (option `substeps`, its numSolverIterations) of symplectic Euler. Forces are
//   held over a step.
// - Collisions are found once a step, a little ahead; continuous collision against fixed bodies.
// - We count whole turns.
// - It mixes coefficients by four rules. Of sqrt(a) and sqrt(b) the product is the geometric mean; sqrt(a^2 + b^2) it
//   can only be given if it is the same for all pairs.
// - It has 16 layers. Ropes hold no thrust, so that there are no rigid rods.
// - One axis serves both bodies of a sliding joint, which must have the same angle.
// - Contact impulses are sums over the step. A half-space is one.
import { NotSupported, centered, corners, mixed, moved, onOff, plus, serve, turned, unwound } from './plumb_engine.mjs';

// Where there is a registry of handles, the engine enters each. That takes longer than to read a contact, and we give
// back what we take.
const { FinalizationRegistry } = globalThis;
delete globalThis.FinalizationRegistry;
const { default: RAPIER } = await import('@dimforge/rapier2d-compat');
Object.assign(globalThis, { FinalizationRegistry });

const GRAVITY = 10; // m/s^2, to which what a body sinks in is stated
const CONTACT = 30; // Hz, of the springs that contacts are (contact_softness); twice that on fixed bodies
const { ActiveHooks, RigidBodyDesc, ColliderDesc, JointData, CoefficientCombineRule: Rule } = RAPIER;
const at = ([x, y]) => ({ x, y });
const place = at([0, 0]); // that the engine writes vectors to

// A point of a collider that is at (x, y), with the cosine and sine of its angle.
const from = ({ c, s, x, y }, local) => [x + c * local.x - s * local.y, y + s * local.x + c * local.y];

class World {
  constructor(scene, options) {
    this.world = new RAPIER.World(at(scene.gravity));
    this.world.numSolverIterations = Number(options.substeps);
    this.world.numInternalPgsIterations = Number(options.iterations);
    this.world.maxCcdSubsteps = options.continuous === 'on' ? 1 : 0;
    this.narrowPhase = this.world.narrowPhase;
    this.loads = scene.loads;
    this.colliders = new Map(); // by handle: body, place in it, and where it was when the bodies were read last
    this.angles = scene.bodies.map(({ angle }) => angle);
    this.sinceRead = 0;
    this.mix = mixingOf(scene);
    this.layers = layersOf(scene);
    // It finds contacts of colliders with hooks anew in each step, whether or not there is one to call.
    this.hooks = options.recycling === 'on' ? ActiveHooks.NONE : ActiveHooks.FILTER_CONTACT_PAIRS;
    this.bodies = scene.bodies.map((body) => this.add(body, options.sleep === 'on'));
    for (const joint of scene.joints) this.join(joint, scene);
  }

  add(body, sleeps) {
    const kinds = { static: 'fixed', kinematic: 'kinematicVelocityBased', dynamic: 'dynamic' };
    const desc = RigidBodyDesc[kinds[body.type]]()
      .setTranslation(...body.position).setRotation(body.angle)
      .setLinvel(...body.velocity).setAngvel(body.angularVelocity)
      .setGravityScale(body.gravityScale).setCanSleep(sleeps).setCcdEnabled(body.bullet)
      .setLinearDamping(body.linearDamping).setAngularDamping(body.angularDamping);
    if (body.type === 'dynamic') desc.setAdditionalMassProperties(body.mass, { x: 0, y: 0 }, body.inertia);
    if (body.fixedRotation) desc.lockRotations();
    const made = this.world.createRigidBody(desc);
    for (const shape of body.shapes) {
      const collider = colliderOf(shape).setDensity(0).setActiveHooks(this.hooks)
        .setCollisionGroups(this.layers(body.layers));
      this.mix(collider, shape);
      const { handle } = this.world.createCollider(collider, made);
      const { translation: { x, y }, rotation } = collider;
      this.colliders.set(handle, { owner: body.index, moves: body.type !== 'static', local: { x, y }, turned: rotation });
    }
    return made;
  }

  join(joint, scene) {
    const pair = joint.bodies.map((i) => scene.bodies[i]);
    const local = (k, point) => at(turned(plus(point, pair[k].position, -1), -pair[k].angle));
    const anchors = [0, 1].map((k) => local(k, joint.anchors?.[k] ?? joint.anchor));
    const start = pair[1].angle - pair[0].angle;
    const turns = joint.type === 'revolute';
    const limits = joint.limits?.map((limit) => limit + (turns ? start : 0));
    if (turns && limits?.some((angle) => Math.abs(angle) >= Math.PI)) {
      throw new NotSupported('limits hinges to half a turn');
    }
    const kinds = {
      revolute: () => JointData.revolute(...anchors),
      weld: () => JointData.fixed(anchors[0], -pair[0].angle, anchors[1], -pair[1].angle),
      prismatic: () => JointData.prismatic(...anchors, at(turned(joint.axis, -pair[0].angle))),
      distance: () => JointData.spring(joint.length, joint.stiffness, joint.damping ?? 0, ...anchors),
    };
    if (joint.motor) throw new NotSupported('drives motors by a gain, without a largest torque or force');
    if (joint.type === 'distance' && !joint.stiffness) throw new NotSupported('has ropes, but no rigid rods');
    if (joint.type === 'prismatic' && start) throw new NotSupported('has one sliding axis for two bodies turned apart');
    const [a, b] = joint.bodies.map((i) => this.bodies[i]);
    const made = this.world.createImpulseJoint(kinds[joint.type](), a, b, true);
    made.setContactsEnabled(false);
    if (limits) made.setLimits(...limits);
  }

  drive(body, velocity) {
    this.bodies[body].setLinvel(at(velocity), true);
  }

  step(dt) {
    this.world.timestep = dt;
    if (this.loads) this.exert(dt);
    this.world.step();
    this.sinceRead += dt;
  }

  exert(dt) {
    const ahead = ((1 - 1 / this.world.numSolverIterations) / 2) * dt; // where the sub-steps begin on average
    this.loads(moved(this.states(), ahead)).forEach(([x, y, torque], i) => {
      this.bodies[i].resetForces(true);
      this.bodies[i].resetTorques(true);
      this.bodies[i].addForce({ x, y }, true);
      this.bodies[i].addTorque(torque, true);
    });
  }

  states() {
    this.read = this.bodies.map((body, i) => {
      const w = body.angvel();
      this.angles[i] = unwound(body.rotation(), this.angles[i] + w * this.sinceRead);
      const { x, y } = body.translation(place);
      const velocity = body.linvel(place);
      return [x, y, this.angles[i], velocity.x, velocity.y, w];
    });
    this.sinceRead = 0;
    return this.read;
  }

  contacts() { // where the bodies were read last
    const all = [];
    for (const [handle, { moves }] of this.colliders) {
      if (!moves) continue;
      this.narrowPhase.contactPairsWith(handle, (other) => {
        if (handle > other && this.colliders.get(other).moves) return; // both list the pair
        this.narrowPhase.contactPair(handle, other, this.world.bodies, (manifold, flipped) =>
          flipped ? this.tell(manifold, other, handle, all) : this.tell(manifold, handle, other, all));
      });
    }
    return all;
  }

  placed(handle) {
    const collider = this.colliders.get(handle);
    const state = this.read[collider.owner];
    if (collider.at !== state) {
      const [x, y, angle] = state;
      const body = { c: Math.cos(angle), s: Math.sin(angle), x, y };
      const [px, py] = from(body, collider.local);
      const [c, s] = collider.turned ? [Math.cos(angle + collider.turned), Math.sin(angle + collider.turned)] : [body.c, body.s];
      Object.assign(collider, { at: state, c, s, x: px, y: py });
    }
    return collider;
  }

  tell(manifold, one, other, all) {
    const [a, b] = [this.placed(one), this.placed(other)];
    const { x, y } = manifold.normal(place);
    for (let i = 0; i < manifold.numContacts(); ++i) {
      const [ax, ay] = from(a, manifold.localContactPoint1(i, place));
      const [bx, by] = from(b, manifold.localContactPoint2(i, place));
      all.push([a.owner, b.owner, (ax + bx) / 2, (ay + by) / 2, x, y, manifold.contactImpulse(i),
                manifold.contactTangentImpulse(i), (bx - ax) * x + (by - ay) * y]);
    }
  }

  free() {
    this.world.free();
  }
}

function colliderOf(shape) {
  const points = () => Float32Array.from(corners(shape).flat());
  const [dx, dy] = shape.to ? plus(shape.to, shape.from, -1) : [0, 0];
  const kinds = {
    circle: () => ColliderDesc.ball(shape.radius).setTranslation(...shape.center),
    box: () => ColliderDesc.cuboid(shape.size[0] / 2, shape.size[1] / 2)
      .setTranslation(...shape.center).setRotation(shape.angle ?? 0),
    polygon: () => ColliderDesc.convexPolyline(points()),
    capsule: () => ColliderDesc.capsule(Math.hypot(dx, dy) / 2, shape.radius)
      .setTranslation(...plus(shape.from, [dx / 2, dy / 2])).setRotation(Math.atan2(-dx, dy)),
    segment: () => ColliderDesc.segment(at(shape.from), at(shape.to)),
    halfspace: () => ColliderDesc.halfspace(at(shape.normal))
      .setTranslation(...shape.normal.map((part) => part * shape.offset)),
  };
  const made = kinds[shape.type]();
  if (!made) throw new NotSupported('takes a polygon to have no inside');
  return made;
}

// Gives a collider coefficients and rules that make the scene's of each pair.
function mixingOf({ bodies, mixing }) {
  const rules = { average: Rule.Average, min: Rule.Min, multiply: Rule.Multiply, max: Rule.Max };
  let rule = rules[mixing.friction];
  let own = (friction) => friction;
  if (mixing.friction === 'geometric') [rule, own] = [Rule.Multiply, Math.sqrt];
  if (mixing.friction === 'pythagorean') {
    const meet = (a, b) => a.index < b.index && (a.type === 'dynamic' || b.type === 'dynamic') && a.layers & b.layers;
    const pairs = bodies.flatMap((a) => bodies.filter((b) => meet(a, b)).flatMap((b) => a.shapes.flatMap((one) =>
      b.shapes.map((other) => mixed.pythagorean(one.friction, other.friction)))));
    if (new Set(pairs).size > 1) throw new NotSupported('cannot mix friction by sqrt(a^2 + b^2)');
    [rule, own] = [Rule.Min, () => pairs[0] ?? 0];
  }
  return (collider, { friction, restitution }) => collider
    .setFriction(own(friction)).setFrictionCombineRule(rule)
    .setRestitution(restitution).setRestitutionCombineRule(rules[mixing.restitution]);
}

// Of 32 layers those count that differ in which bodies are on them.
function layersOf({ bodies }) {
  const has = (layers, bit) => (layers >>> bit) & 1;
  const bits = new Map();
  for (let bit = 0; bit < 32; ++bit) bits.set(bodies.map(({ layers }) => has(layers, bit)).join(''), bit);
  if (bits.size > 16) throw new NotSupported('has 16 layers');
  return (layers) => [...bits.values()].reduce((groups, bit, k) => groups | (has(layers, bit) * (0x10001 << k)), 0);
}

// As for Box2D 3, whose method this is. The slop is the depth of a contact's spring under one weight, 2.5 g/w^2 for a
// square on its like (two corners, each with half the weight and an effective mass of m/5). A joint falls for one
// sub-step before it is pulled back. Impacts bounce at the end of the step that finds them, and the last solve of a step
// brakes what would touch within a sub-step more. A contact keeps its points on both bodies for a step.
function stepping({ substeps, iterations, sleep }, dt) {
  const h = dt / Number(substeps);
  return { arithmetic: 'float', substep: h, drift: 0.5, dampingInterval: dt, order: 1, heldAnchors: true, tangentRotation: true,
           impactLag: 2 * Number(substeps), impactLead: 1, slop: (2.5 * GRAVITY) / (2 * Math.PI * CONTACT) ** 2,
           contactFrequency: CONTACT, fixedContactFrequency: 2 * CONTACT, jointSlop: GRAVITY * h * h, iterations: Number(iterations),
           wholeImpulses: sleep === 'off', springLimit: 2 };
}

await RAPIER.init();
serve({
  name: 'rapier', version: RAPIER.version(), language: 'Rust', execution: 'WebAssembly',
  about: 'Rapier 2D: soft contacts in sub-steps, float', source: '@dimforge/rapier2d-compat, Dimforge, rapier.rs',
  caveats: [
    'float arithmetic',
    'contacts are damped springs of 30 Hz, 60 Hz on fixed bodies: they do not converge with the step',
    'restitution acts once, at the end of a step, on contacts that carried nothing in the step before; that of 1 always',
    'restitution acts without friction, which takes mu m v from an impact that slips, not mu (1 + e) m v',
    'rotations advance by atan(w h): fast spins lose some of their angle',
    'damping c divides velocities by 1 + c dt; the scene means e^(-c dt)',
    'keeps a contact as it was until the bodies have moved by 5 cm to each other or turned by 11 degrees',
    'nothing moves faster than 400 m/s',
    'springs are implicit and lose energy',
    'sleeping is off by default',
  ],
  options: [
    { key: 'substeps', value: '4', about: 'sub-steps of a step', min: 1, max: 1000, whole: true,
      ladder: ['1', '2', '4', '8'] },
    { key: 'iterations', value: '1', about: 'of the solver in each sub-step', min: 1, max: 1000, whole: true },
    onOff('continuous', 'on', 'continuous collision', 'stops bodies at fixed ones within a step', 'bodies may overlap'),
    onOff('recycling', 'on', 'contact recycling', 'keeps contacts while two bodies move by less than 5 cm',
          'finds contacts anew in each step'),
    onOff('sleep', 'off', 'sleeping', 'stops bodies that hardly move', 'bodies never sleep'),
  ],
}, stepping, (scene, masses, options) => new World(centered(scene, masses), options));
