// What this engine does differently is in its caveats, below: it is Box2D 2.3 in JavaScript
// (github.com/piqnt/planck.js, src/Settings.ts and src/dynamics/Solver.ts of 1.4.2). Besides:
// - We mix the coefficients and set them on each contact when it begins.
// - No capsules: we build them from two circles and a rectangle, thinned by its skin so that sides and caps are flush.
// - No half-spaces: we build them from an edge. An edge has two sides.
// - Bodies never sleep.
import { BoxShape, CircleShape, DistanceJoint, EdgeShape, PolygonShape, PrismaticJoint, RevoluteJoint, Settings,
         WeldJoint, World as PlanckWorld, WorldManifold } from 'planck';
import { NotSupported, centered, corners, mixed, onOff, plus, serve, tuned, turned, writeContact } from './plumb_engine.mjs';

const SKIN = Settings.polygonRadius;
const at = ([x, y]) => ({ x, y });

class World {
  constructor(scene, options) {
    Settings.velocityThreshold = Number(options.restitution);
    this.iterations = [Number(options.velocity), Number(options.position)];
    this.world = new PlanckWorld({ gravity: at(scene.gravity), allowSleep: false, warmStarting: options.warm === 'on',
                                   continuousPhysics: options.continuous === 'on' });
    this.loads = scene.loads;
    this.met = new Map(); // where impulses act: before the bodies move
    this.rows = [];       // of this step, which solves a contact several times if continuous collision acts
    this.solved = [];     // the contact of each row
    this.place = [];      // and which of its points
    const of = (contact) => [contact.getFixtureA().getUserData(), contact.getFixtureB().getUserData()];
    this.world.on('begin-contact', (contact) => {
      const [a, b] = of(contact);
      contact.setFriction(mixed[scene.mixing.friction](a.friction, b.friction));
      contact.setRestitution(mixed[scene.mixing.restitution](a.restitution, b.restitution));
    });
    this.world.on('pre-solve', (contact) => {
      if (!this.met.has(contact)) this.met.set(contact, new WorldManifold());
      contact.getWorldManifold(this.met.get(contact));
    });
    this.world.on('post-solve', (contact, { normalImpulses, tangentImpulses }) => {
      const { normal, points, separations } = this.met.get(contact);
      const [{ owner: a }, { owner: b }] = of(contact);
      const count = contact.v_pointCount; // of two points that hardly differ it solves one, and lists two impulses
      for (let i = 0; i < count; ++i) {   // its tangent is the normal turned by -90 degrees
        this.place.push(i);
        writeContact(this.rows, this.solved.push(contact) - 1, a, b, points[i].x, points[i].y, normal.x, normal.y,
                     normalImpulses[i], -tangentImpulses[i], separations[i]);
      }
    });
    this.bodies = scene.bodies.map((body) => this.add(body, scene.extent));
    for (const joint of scene.joints) this.join(joint, scene.bodies);
  }

  add(body, extent) {
    const { type, angle, angularVelocity, linearDamping, angularDamping, fixedRotation, bullet, gravityScale } = body;
    const made = this.world.createBody({ type, position: at(body.position), angle, linearVelocity: at(body.velocity),
      angularVelocity, linearDamping, angularDamping, fixedRotation, bullet, gravityScale });
    for (const shape of body.shapes) {
      const userData = { owner: body.index, friction: shape.friction, restitution: shape.restitution };
      const fixture = { userData, density: 0, filterCategoryBits: body.layers, filterMaskBits: body.layers };
      for (const part of parts[shape.type](shape, extent)) made.createFixture(part, fixture);
    }
    if (type === 'dynamic') made.setMassData({ mass: body.mass, center: { x: 0, y: 0 }, I: body.inertia });
    return made;
  }

  join(joint, bodies) {
    const ends = joint.bodies.map((i) => bodies[i]);
    const [a, b] = joint.bodies.map((i) => this.bodies[i]);
    const [low, high] = joint.limits ?? [0, 0];
    const { speed: motorSpeed = 0, strength = 0 } = joint.motor ?? {};
    const motor = { enableMotor: !!joint.motor, motorSpeed, maxMotorTorque: strength, maxMotorForce: strength };
    const limits = { enableLimit: !!joint.limits, lowerAngle: low, upperAngle: high, lowerTranslation: low,
                     upperTranslation: high };
    const kinds = {
      revolute: () => new RevoluteJoint({ ...limits, ...motor }, a, b, at(joint.anchor)),
      weld: () => new WeldJoint({}, a, b, at(joint.anchor)),
      prismatic: () => new PrismaticJoint({ ...limits, ...motor }, a, b, at(joint.anchor), at(joint.axis)),
      distance: () => {
        const { hertz, ratio } = joint.stiffness ? tuned(joint, ends) : { hertz: 0, ratio: 0 };
        const made = new DistanceJoint({ frequencyHz: hertz, dampingRatio: ratio }, a, b, ...joint.anchors.map(at));
        made.setLength(joint.length); // the constructor takes it from the anchors
        return made;
      },
    };
    this.world.createJoint(kinds[joint.type]());
  }

  drive(body, velocity) {
    this.bodies[body].setLinearVelocity(at(velocity));
  }

  step(dt) {
    this.solved.length = this.place.length = 0;
    if (this.loads) {
      this.loads(this.states()).forEach(([x, y, torque], i) => {
        this.bodies[i].applyForceToCenter({ x, y }, true);
        this.bodies[i].applyTorque(torque, true);
      });
    }
    this.world.step(dt, ...this.iterations);
  }

  states() {
    return this.bodies.map((body) => {
      const { x, y } = body.getWorldCenter();
      const velocity = body.getLinearVelocity();
      return [x, y, body.getAngle(), velocity.x, velocity.y, body.getAngularVelocity()];
    });
  }

  contacts() {
    this.rows.length = this.solved.length;
    const earlier = new Map(); // the rows of each contact
    return this.rows.filter((row, k) => {
      const contact = this.solved[k];
      const i = this.place[k];
      if (i === 0) {
        left.pointCount = 0; // and it stays so if the bodies have come apart within the step
        contact.getWorldManifold(left);
      }
      if (i < left.pointCount) row[8] = left.separations[i];
      if (!earlier.has(contact)) earlier.set(contact, []);
      const same = earlier.get(contact).find((one) => [2, 3, 4, 5].every((place) => one[place] === row[place]));
      if (same === undefined) {
        earlier.get(contact).push(row);
        return true;
      }
      same[6] += row[6]; // solved again where it was
      same[7] += row[7];
      return false;
    });
  }
}

const left = new WorldManifold(); // that the engine writes to

const rectangle = (w, h, center, angle) => new BoxShape(w / 2, h / 2, at(center), angle);

const parts = {
  circle: ({ center, radius }) => [new CircleShape(at(center), radius)],
  box: ({ size, center, angle = 0 }) => [rectangle(...size, center, angle)],
  polygon: (shape) => {
    const points = corners(shape);
    if (points.length > Settings.maxPolygonVertices) throw new NotSupported('polygons have at most twelve vertices');
    const close = (a, b) => a !== b && Math.hypot(...plus(a, b, -1)) <= Settings.linearSlop / 2;
    if (points.some((a) => points.some((b) => close(a, b)))) {
      throw new NotSupported('welds vertices closer than 0.0025 m');
    }
    return [new PolygonShape(points.map(at))];
  },
  capsule: ({ from, to, radius }) => {
    if (radius <= 2 * SKIN) {
      throw new NotSupported('has no capsules; one built from a rectangle with a skin needs a radius above 0.02 m');
    }
    const along = plus(to, from, -1);
    const middle = plus(from, along, 0.5);
    const side = rectangle(Math.hypot(...along), 2 * (radius - SKIN), middle, Math.atan2(along[1], along[0]));
    return [side, new CircleShape(at(from), radius), new CircleShape(at(to), radius)];
  },
  segment: ({ from, to }) => [new EdgeShape(at(from), at(to))],
  halfspace: ({ normal: [nx, ny], offset }, extent) => {
    const end = (far) => at(turned([far, offset], Math.atan2(-nx, ny)));
    return [new EdgeShape(end(extent), end(-extent))];
  },
};

// Two polygons touch when their skins do. The overlap of the skins that is left alone is the slop, so that they come to
// rest between skin - slop and skin apart, circles between 0 and the slop in each other; it is also the error below
// which a joint's position counts as solved. A hinge is pushed back to two degrees past its limit. Friction bounds the
// sum of the impulses, and can hold a body completely.
function stepping({ velocity, position, restitution }) {
  return { arithmetic: 'double', drift: 0.5, order: 1, skin: 2 * SKIN, slop: Settings.linearSlop,
           jointSlop: Settings.linearSlop, angularSlop: Settings.angularSlop, iterations: Number(velocity),
           positionIterations: Number(position), restitutionThreshold: Number(restitution), wholeImpulses: true,
           springLimit: 2 };
}

serve({
  name: 'planck', version: '1.4.2',
  about: 'Box2D 2.3 in JavaScript: sequential impulses, double',
  source: 'planck, Ali Shakiba, after Box2D by Erin Catto, piqnt.com/planck.js',
  caveats: [
    'polygons, boxes and edges carry a skin of 0.01 m, circles none: two boxes come to rest 0.015 m apart',
    'nothing bounces below a closing speed of 1 m/s (option restitution)',
    '8 velocity and 3 position iterations leave errors in tall stacks and at large mass ratios',
    'damping c divides velocities by 1 + c h each step; the scene means e^(-c h)',
    'nothing moves by more than 2 m or turns by more than a quarter turn in a step',
    'a body that continuous collision stops loses the rest of its step',
    'vertices closer than 0.0025 m are welded; polygons have at most twelve',
    'a soft distance joint is an implicit spring, tuned by frequency',
  ],
  options: [
    { key: 'velocity', value: '8', about: 'iterations of the velocity solver', min: 1, max: 10000, whole: true,
      ladder: ['4', '8', '16'] },
    { key: 'position', value: '3', about: 'iterations of the position solver', min: 1, max: 10000, whole: true },
    { key: 'restitution', value: '1', about: 'm/s, closing speed below which nothing bounces', min: 0, max: 100 },
    onOff('continuous', 'on', 'continuous collision', 'stops bodies at fixed ones within a step', 'bodies may overlap'),
    onOff('warm', 'on', 'warm starting', "starts from the last step's impulses", 'starts from zero'),
  ],
}, stepping, (scene, masses, options) => new World(centered(scene, masses), options));
