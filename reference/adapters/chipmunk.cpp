// What this engine does differently
// - Moves positions first, with the old velocities, then updates velocities and solves contacts where bodies now are:
//   free fall is off by -g t h/2. Forces are evaluated after the move, as its own springs and planet demo do.
// - Contacts are solved by accumulated impulses, 10 iterations, warm-started except in their first step; overlap is
// taken
//   out by pseudo-velocities, a tenth of it per 1/60 s.
// - Overlap up to the collision slop, 0.1 m by default, is left alone (option `slop`). Nothing pushes back until then:
//   what starts apart may come to rest that deep.
// - No continuous collision: fast bodies pass through thin ones. `bullet` has no meaning.
// - No threshold for restitution.
// - Joints are held by velocities and a bias alone, without projection: they give a little and recover.
// - A soft distance joint is an explicit spring with a damper of its own.
// - Damping c leaves e^(-c) of the velocity each second, exactly what the scene means.
// - One coefficient of friction; mixed values are ours, set on each pair before every solve.
// - Half-spaces are built from a box as large as the scene can reach: a box, since stacks topple on its segments that
//   stand on its polygons.
// - A sliding joint is a groove, far longer than the scene, and a gear.
// - As Debian ships it, its assertions are compiled in, which cost time.
// - Contacts' impulses count what a pair carried when it last touched, though at its first touch anew none of that is
//   given: they are no sums over the step.
// - Sleeping is off unless asked for; sleepers keep stale velocities.
// Every body's frame is moved to its centre of mass; mass and inertia are those of plumb::mass_of.

#include <chipmunk/chipmunk.h>
#include <chipmunk/chipmunk_structs.h>
#include <fcntl.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <deque>
#include <limits>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "reference/loads.h"
#include "reference/scene_facts.h"
#include "reference/simulation.h"
#include "scenarios/scene/mass.h"

namespace plumb {
namespace {

cpVect to_cp(Vec v) { return cpv(v.x, v.y); }
Vec from_cp(cpVect v) { return {v.x, v.y}; }

struct Free {
  void operator()(cpBody* body) const { cpBodyFree(body); }
  void operator()(cpShape* shape) const { cpShapeFree(shape); }
  void operator()(cpConstraint* constraint) const { cpConstraintFree(constraint); }
  void operator()(cpSpace* space) const { cpSpaceFree(space); }
};

template <class T>
using Owned = std::unique_ptr<T, Free>;

// Makes Chipmunk's shapes for one geometry of a body.
struct Hang {
  cpBody* body;
  double reach;  // m
  std::vector<cpShape*> made;

  void operator()(const Circle& circle) { made.push_back(cpCircleShapeNew(body, circle.radius, to_cp(circle.center))); }

  void operator()(const Box& box) {
    const double x = box.size.x / 2;
    const double y = box.size.y / 2;
    const std::vector<cpVect> corners{cpv(-x, -y), cpv(x, -y), cpv(x, y), cpv(-x, y)};
    polygon(corners, cpTransformRigid(to_cp(box.center), box.angle));
  }

  void operator()(const Polygon& given) {
    std::vector<cpVect> vertices;
    for (const Vec& vertex : given.vertices) vertices.push_back(to_cp(vertex));
    polygon(vertices, cpTransformIdentity);
  }

  void operator()(const Capsule& capsule) { segment(to_cp(capsule.from), to_cp(capsule.to), capsule.radius); }

  void operator()(const Segment& given) { segment(to_cp(given.from), to_cp(given.to), 0); }

  void operator()(const HalfSpace& half_space) {
    const Vec n = half_space.normal;
    const double depth = half_space.offset - reach / 2;
    (*this)(Box{{4 * reach, reach}, {n.x * depth, n.y * depth}, std::atan2(-n.x, n.y)});
  }

  void polygon(const std::vector<cpVect>& vertices, cpTransform transform) {
    made.push_back(cpPolyShapeNew(body, static_cast<int>(vertices.size()), vertices.data(), transform, 0));
  }

  void segment(cpVect from, cpVect to, double radius) { made.push_back(cpSegmentShapeNew(body, from, to, radius)); }
};

class Chipmunk : public Simulation {
 public:
  Chipmunk(const Scene& scene, const Settings& settings)
      : loads_(scene), mixing_(scene.mixing), reach_(reach(scene)), space_(cpSpaceNew()) {
    cpSpaceSetGravity(space_.get(), to_cp(scene.gravity));
    cpSpaceSetIterations(space_.get(), static_cast<int>(std::stod(settings.at("iterations"))));
    cpSpaceSetCollisionSlop(space_.get(), std::stod(settings.at("slop")));
    constexpr double usual = 0.5;  // s, of its demos
    if (settings.at("sleep") == "on") cpSpaceSetSleepTimeThreshold(space_.get(), usual);
    cpCollisionHandler* handler = cpSpaceAddDefaultCollisionHandler(space_.get());
    handler->preSolveFunc = mix;
    handler->userData = this;
    for (const Body& body : scene.bodies) add(body);
    for (const Joint& joint : scene.joints) {
      std::visit([&](const auto& kind) { add(kind); }, joint);
    }
    states_.resize(bodies_.size());
  }

  void step(double dt) override {
    loaded_ = {};
    cpSpaceStep(space_.get(), dt);
  }

  void read(std::span<BodyState> out) const override {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const cpBody* body = bodies_[i].get();
      out[i] = {from_cp(cpBodyGetPosition(body)), cpBodyGetAngle(body), from_cp(cpBodyGetVelocity(body)),
                cpBodyGetAngularVelocity(body)};
    }
  }

  void read_contacts(std::vector<ContactState>& out) const override {
    for (const Owned<cpBody>& body : bodies_) cpBodyEachArbiter(body.get(), append, &out);
  }

 private:
  // What a body must know of the scene it came from.
  struct Rider {
    Chipmunk* simulation = nullptr;
    std::size_t index = 0;
    double gravity_scale = 1;
    double linear_damping = 0;   // 1/s
    double angular_damping = 0;  // 1/s
  };

  static const Rider& rider_of(const cpBody* body) { return *static_cast<const Rider*>(cpBodyGetUserData(body)); }
  static const Surface& surface_of(const cpShape* shape) {
    return *static_cast<const Surface*>(cpShapeGetUserData(shape));
  }

  void add(const Body& given) {
    const Body body = centered(given);
    cpBody* made = bodies_.emplace_back(make(given)).get();
    riders_.push_back({this, bodies_.size() - 1, body.gravity_scale, body.linear_damping, body.angular_damping});
    cpBodySetUserData(made, &riders_.back());
    cpBodySetPosition(made, to_cp(body.position));
    cpBodySetAngle(made, body.angle);
    if (body.type != BodyType::fixed) {
      cpBodySetVelocity(made, to_cp(body.velocity));
      cpBodySetAngularVelocity(made, body.angular_velocity);
    }
    if (body.type == BodyType::dynamic) cpBodySetVelocityUpdateFunc(made, accelerate);
    cpSpaceAddBody(space_.get(), made);
    for (const Shape& shape : body.shapes) add(made, shape, body.layers);
  }

  static cpBody* make(const Body& body) {
    if (body.type == BodyType::fixed) return cpBodyNewStatic();
    if (body.type == BodyType::kinematic) return cpBodyNewKinematic();
    const Mass mass = mass_of(body);
    return cpBodyNew(mass.mass, body.fixed_rotation ? std::numeric_limits<double>::infinity() : mass.inertia);
  }

  void add(cpBody* body, const Shape& shape, std::uint32_t layers) {
    surfaces_.push_back(shape.surface);
    Hang hang{body, reach_, {}};
    std::visit(hang, shape.geometry);
    for (cpShape* made : hang.made) {
      shapes_.emplace_back(made);
      cpShapeSetUserData(made, &surfaces_.back());
      cpShapeSetFilter(made, cpShapeFilterNew(CP_NO_GROUP, layers, layers));
      cpSpaceAddShape(space_.get(), made);
    }
  }

  void hold(cpConstraint* constraint) {
    cpConstraintSetCollideBodies(constraint, cpFalse);
    constraints_.emplace_back(constraint);
    cpSpaceAddConstraint(space_.get(), constraint);
  }

  cpVect local(std::size_t body, Vec point) const { return cpBodyWorldToLocal(bodies_[body].get(), to_cp(point)); }

  // Keeps the angle between two bodies.
  void gear(cpBody* a, cpBody* b) { hold(cpGearJointNew(a, b, cpBodyGetAngle(b) - cpBodyGetAngle(a), 1)); }

  void add(const Revolute& joint) {
    hold(cpPivotJointNew(bodies_[joint.a].get(), bodies_[joint.b].get(), to_cp(joint.anchor)));
  }

  void add(const Distance& joint) {
    cpBody* a = bodies_[joint.a].get();
    cpBody* b = bodies_[joint.b].get();
    const cpVect on_a = local(joint.a, joint.anchor_a);
    const cpVect on_b = local(joint.b, joint.anchor_b);
    if (joint.stiffness > 0) {
      hold(cpDampedSpringNew(a, b, on_a, on_b, joint.length, joint.stiffness, joint.damping));
    } else {
      cpConstraint* pin = cpPinJointNew(a, b, on_a, on_b);
      cpPinJointSetDist(pin, joint.length);
      hold(pin);
    }
  }

  void add(const Prismatic& joint) {
    cpBody* a = bodies_[joint.a].get();
    cpBody* b = bodies_[joint.b].get();
    const double far = 2 * reach_ / std::hypot(joint.axis.x, joint.axis.y);
    const Vec from{joint.anchor.x - far * joint.axis.x, joint.anchor.y - far * joint.axis.y};
    const Vec to{joint.anchor.x + far * joint.axis.x, joint.anchor.y + far * joint.axis.y};
    hold(cpGrooveJointNew(a, b, local(joint.a, from), local(joint.a, to), local(joint.b, joint.anchor)));
    gear(a, b);
  }

  void add(const Weld& joint) {
    cpBody* a = bodies_[joint.a].get();
    cpBody* b = bodies_[joint.b].get();
    hold(cpPivotJointNew(a, b, to_cp(joint.anchor)));
    gear(a, b);
  }

  // Sets the scene's coefficients: Chipmunk's own, products, are computed anew in every step.
  static cpBool mix(cpArbiter* arbiter, cpSpace*, cpDataPointer simulation) {
    const Mixing& mixing = static_cast<const Chipmunk*>(simulation)->mixing_;
    const Surface& a = surface_of(arbiter->a);
    const Surface& b = surface_of(arbiter->b);
    cpArbiterSetFriction(arbiter, mixed_dynamic_friction(mixing, a, b));
    cpArbiterSetRestitution(arbiter, mixed_restitution(mixing, a, b));
    return cpTrue;
  }

  // Called for each body once all have moved.
  static void accelerate(cpBody* body, cpVect gravity, cpFloat, cpFloat dt) {
    const Rider& rider = rider_of(body);
    const Load load = rider.simulation->load(rider.index);
    body->f = cpvadd(body->f, to_cp(load.force));
    body->t += load.torque;
    const double turning = body->w;
    const double kept = std::exp(-rider.linear_damping * dt);
    cpBodyUpdateVelocity(body, cpvmult(gravity, rider.gravity_scale), kept, dt);
    // Chipmunk knows one damping for both.
    body->w += turning * (std::exp(-rider.angular_damping * dt) - kept);
  }

  Load load(std::size_t index) {
    if (!loads_.any()) return {};
    if (loaded_.empty()) {
      read(states_);
      loaded_ = loads_.at(states_);
    }
    return loaded_[index];
  }

  // Each pair is met twice, once from either body.
  static void append(cpBody* body, cpArbiter* arbiter, void* data) {
    if (arbiter->body_a != body) return;
    auto& out = *static_cast<std::vector<ContactState>*>(data);
    for (int i = 0; i < arbiter->count; ++i) {
      const cpContact& contact = arbiter->contacts[i];
      const cpVect on_a = cpvadd(arbiter->body_a->p, contact.r1);
      const cpVect on_b = cpvadd(arbiter->body_b->p, contact.r2);
      out.push_back({rider_of(arbiter->body_a).index, rider_of(arbiter->body_b).index,
                     from_cp(cpvlerp(on_a, on_b, 0.5)), from_cp(arbiter->n), contact.jnAcc, contact.jtAcc,
                     cpvdot(cpvsub(on_b, on_a), arbiter->n)});
    }
  }

  Loads loads_;
  std::vector<BodyState> states_;
  std::span<const Load> loaded_;  // of this step; empty until asked for
  Mixing mixing_;
  double reach_;
  std::deque<Rider> riders_;      // bodies point into it
  std::deque<Surface> surfaces_;  // shapes point into it
  std::vector<Owned<cpBody>> bodies_;
  std::vector<Owned<cpShape>> shapes_;
  std::vector<Owned<cpConstraint>> constraints_;
  Owned<cpSpace> space_;  // ends first: it touches its bodies
};

std::string unsupported(const Scene& scene, const Settings&) {
  for (std::string reason : {needs_two_frictions(scene), needs_dynamic_half_space(scene), needs_massless_body(scene)}) {
    if (!reason.empty()) return reason;
  }
  return "";
}

const Engine& self() { return *Catalog<Engine>::find("chipmunk"); }

Stepping stepping(const Settings& settings, double dt) {
  Stepping stated;
  stated.dt = dt;
  stated.h = dt;
  stated.drift = -0.5;
  stated.order = 1;
  stated.order_in_contact = 1;
  stated.impact_lag = 1;
  stated.gap = std::stod(complete(self(), settings).at("slop"));
  stated.creep = 0;
  stated.restitution_threshold = 0;
  stated.iterations = std::stoi(complete(self(), settings).at("iterations"));
  stated.epsilon = std::ldexp(1.0, -53);
  stated.whole_impulses = false;
  stated.spring_limit = 2;  // v += a(x') dt after x' = x + v dt: symplectic Euler's twin, with v half a step behind
  return stated;
}

// A library with assertions greets on standard output when its first space is made: made here, with the output turned
// away, so that no report ever begins with it.
void hear_greeting() {
  std::fflush(stdout);
  const int output = dup(STDOUT_FILENO);
  const int nowhere = open("/dev/null", O_WRONLY);
  if (output < 0 || nowhere < 0) return;
  dup2(nowhere, STDOUT_FILENO);
  Owned<cpSpace>(cpSpaceNew()).reset();
  std::fflush(stdout);
  dup2(output, STDOUT_FILENO);
  close(output);
  close(nowhere);
}

Engine chipmunk() {
  hear_greeting();
  return {
      .name = "chipmunk",
      .about = "Chipmunk 7: accumulated impulses, positions before velocities, double",
      .source = std::string("Chipmunk2D ") + cpVersionString + ", Scott Lembcke, chipmunk-physics.net",
      .options =
          {
              {.key = "iterations", .value = "10", .about = "of the solver", .min = 1, .max = 10000, .whole = true},
              {.key = "slop", .value = "0.1", .about = "m, overlap left alone", .min = 0, .max = 1},
              {.key = "sleep",
               .value = "off",
               .choices = {{"on", "stops groups of bodies that hardly move"}, {"off", "bodies never sleep"}},
               .about = "sleeping"},
          },
      .ladders = {{.option = "iterations", .values = {"5", "10", "20"}}},
      .stepping = stepping,
      .unsupported = unsupported,
      .build = [](const Scene& scene, const Settings& settings) -> std::unique_ptr<Simulation> {
        return std::make_unique<Chipmunk>(scene, complete(self(), settings));
      },
  };
}

const Catalog<Engine>::Entry entry{chipmunk};

}  // namespace
}  // namespace plumb
