// What this engine does differently is in `caveats`. Besides:
// - Forces are evaluated after the move, as its own springs and planet demo do.
// - Overlap is removed by pseudo-velocities, a tenth of it per 1/60 s. The library leaves an overlap of 0.1 alone, made
//   for worlds in pixels. In metres that is a tenth of a box, so we run 0.005 by default, Box2D's, and show what the
//   library's costs as a variant of its own.
// - One coefficient of friction. We mix the coefficients and set them on each pair before every solve.
// - Half-spaces are built from a box as large as the scene can reach. A segment would not do: stacks that stand on
//   polygons topple on it.
// - A sliding joint is a groove, far longer than the scene, and a gear.
// - Sleeping bodies keep stale velocities.
// The origin of every body is moved to its centre of mass; mass and inertia come from plumb::mass_of.

#include <chipmunk/chipmunk.h>
#include <chipmunk/chipmunk_structs.h>
#include <fcntl.h>
#include <unistd.h>

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <deque>
#include <limits>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "reference/adapter.h"
#include "reference/scene_facts.h"
#include "reference/simulation.h"
#include "scenarios/scene/mass.h"

// Chipmunk says here what its assertions find, and calls this function instead of its own. Its warnings ("High GJK
// iterations") are for who writes the library: they change no run, and would stand between the lines of a report. An
// error ends the process, so it is said. Weak, as a static library has its own, which then stays.
extern "C" [[gnu::weak]] void cpMessage(const char* condition, const char* file, int line, int is_error, int /*hard*/,
                                        const char* message, ...) {
  if (is_error == 0) return;
  std::fputs("Chipmunk: ", stderr);
  va_list values;
  va_start(values, message);
  std::vfprintf(stderr, message, values);
  va_end(values);
  std::fprintf(stderr, " (%s, %s:%d)\n", condition, file, line);
}

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

// Makes the Chipmunk shape of a geometry of a body.
struct MakeShape {
  cpBody* body;
  double extent;  // m, of the scene

  cpShape* operator()(const Circle& circle) const {
    return cpCircleShapeNew(body, circle.radius, to_cp(circle.center));
  }

  cpShape* operator()(const Box& box) const {
    const double x = box.size.x / 2;
    const double y = box.size.y / 2;
    return polygon({cpv(-x, -y), cpv(x, -y), cpv(x, y), cpv(-x, y)}, cpTransformRigid(to_cp(box.center), box.angle));
  }

  cpShape* operator()(const Polygon& given) const {
    return polygon(converted(given.vertices, to_cp), cpTransformIdentity);
  }

  cpShape* operator()(const Capsule& capsule) const {
    return cpSegmentShapeNew(body, to_cp(capsule.from), to_cp(capsule.to), capsule.radius);
  }

  cpShape* operator()(const Segment& given) const {
    return cpSegmentShapeNew(body, to_cp(given.from), to_cp(given.to), 0);
  }

  cpShape* operator()(const HalfSpace& half_space) const {
    const Vec n = half_space.normal;
    const double depth = half_space.offset - extent / 2;
    return (*this)(Box{{4 * extent, extent}, {n.x * depth, n.y * depth}, std::atan2(-n.x, n.y)});
  }

  cpShape* polygon(const std::vector<cpVect>& vertices, cpTransform transform) const {
    return cpPolyShapeNew(body, static_cast<int>(vertices.size()), vertices.data(), transform, 0);
  }
};

class Chipmunk : public Simulation {
 public:
  Chipmunk(const Scene& scene, const Settings& settings)
      : loads_(scene), mixing_(scene.mixing), extent_(scene_extent(scene)), space_(cpSpaceNew()) {
    cpSpaceSetGravity(space_.get(), to_cp(scene.gravity));
    cpSpaceSetIterations(space_.get(), whole_number(settings, "iterations"));
    cpSpaceSetCollisionSlop(space_.get(), std::stod(settings.at("slop")));
    constexpr double time_to_sleep = 0.5;  // s, as in its demos
    if (settings.at("sleep") == "on") cpSpaceSetSleepTimeThreshold(space_.get(), time_to_sleep);
    cpCollisionHandler* handler = cpSpaceAddDefaultCollisionHandler(space_.get());
    handler->preSolveFunc = mix;
    handler->userData = this;
    for (const Body& body : scene.bodies) add(body);
    for (const Joint& joint : scene.joints) {
      visit_supported([&](const auto& kind) { add(kind); }, joint);
    }
  }

  void step(double dt) override {
    step_loads_ = {};
    cpSpaceStep(space_.get(), dt);
  }

  void drive(std::size_t body, Vec velocity) override { cpBodySetVelocity(bodies_[body].get(), to_cp(velocity)); }

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
  // What a body keeps from the scene.
  struct Tag {
    Chipmunk* simulation = nullptr;
    std::size_t index = 0;
    double gravity_scale = 1;
    double linear_damping = 0;   // 1/s
    double angular_damping = 0;  // 1/s
  };

  static const Tag& tag_of(const cpBody* body) { return *static_cast<const Tag*>(cpBodyGetUserData(body)); }
  static const Surface& surface_of(const cpShape* shape) {
    return *static_cast<const Surface*>(cpShapeGetUserData(shape));
  }

  void add(const Body& given) {
    const Body body = centered(given);
    cpBody* made = bodies_.emplace_back(make(given)).get();
    tags_.push_back({this, bodies_.size() - 1, body.gravity_scale, body.linear_damping, body.angular_damping});
    cpBodySetUserData(made, &tags_.back());
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
    cpShape* made = shapes_.emplace_back(visit_supported(MakeShape{body, extent_}, shape.geometry)).get();
    cpShapeSetUserData(made, &surfaces_.back());
    cpShapeSetFilter(made, cpShapeFilterNew(CP_NO_GROUP, layers, layers));
    cpSpaceAddShape(space_.get(), made);
  }

  void hold(cpConstraint* constraint) {
    cpConstraintSetCollideBodies(constraint, cpFalse);
    constraints_.emplace_back(constraint);
    cpSpaceAddConstraint(space_.get(), constraint);
  }

  cpVect local(std::size_t body, Vec point) const { return cpBodyWorldToLocal(bodies_[body].get(), to_cp(point)); }

  // The library divides by what both bodies' angles yield to an impulse.
  static bool may_turn(cpBody* a, cpBody* b) {
    return std::isfinite(cpBodyGetMoment(a)) || std::isfinite(cpBodyGetMoment(b));
  }

  // Keeps the angle between two bodies.
  void gear(cpBody* a, cpBody* b) {
    if (may_turn(a, b)) hold(cpGearJointNew(a, b, cpBodyGetAngle(b) - cpBodyGetAngle(a), 1));
  }

  void add(const Revolute& joint) {
    cpBody* a = bodies_[joint.a].get();
    cpBody* b = bodies_[joint.b].get();
    hold(cpPivotJointNew(a, b, to_cp(joint.anchor)));
    if (!may_turn(a, b)) return;
    if (joint.motor) {
      cpConstraint* motor = cpSimpleMotorNew(a, b, -joint.motor->speed);  // its rate is of a relative to b
      cpConstraintSetMaxForce(motor, joint.motor->strength);
      hold(motor);
    }
    if (!joint.limits) return;
    const double start = cpBodyGetAngle(b) - cpBodyGetAngle(a);
    hold(cpRotaryLimitJointNew(a, b, start + joint.limits->low, start + joint.limits->high));
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
    const Limits ends = joint.limits.value_or(Limits{-2 * extent_, 2 * extent_});
    const auto along = [&](double way) {
      const double share = way / std::hypot(joint.axis.x, joint.axis.y);
      return local(joint.a, {joint.anchor.x + share * joint.axis.x, joint.anchor.y + share * joint.axis.y});
    };
    hold(cpGrooveJointNew(a, b, along(ends.low), along(ends.high), local(joint.b, joint.anchor)));
    gear(a, b);
  }

  void add(const Weld& joint) {
    cpBody* a = bodies_[joint.a].get();
    cpBody* b = bodies_[joint.b].get();
    hold(cpPivotJointNew(a, b, to_cp(joint.anchor)));
    gear(a, b);
  }

  // Sets the scene's coefficients: Chipmunk computes its own, the products, in every step.
  static cpBool mix(cpArbiter* arbiter, cpSpace*, cpDataPointer simulation) {
    const Mixing& mixing = static_cast<const Chipmunk*>(simulation)->mixing_;
    const Surface& a = surface_of(arbiter->a);
    const Surface& b = surface_of(arbiter->b);
    cpArbiterSetFriction(arbiter, mixed_dynamic_friction(mixing, a, b));
    cpArbiterSetRestitution(arbiter, mixed_restitution(mixing, a, b));
    return cpTrue;
  }

  // Called for each body after all have moved.
  static void accelerate(cpBody* body, cpVect gravity, cpFloat, cpFloat dt) {
    const Tag& tag = tag_of(body);
    const Load load = tag.simulation->load(tag.index);
    body->f = cpvadd(body->f, to_cp(load.force));
    body->t += load.torque;
    const double turning = body->w;
    const double kept = std::exp(-tag.linear_damping * dt);
    cpBodyUpdateVelocity(body, cpvmult(gravity, tag.gravity_scale), kept, dt);
    // Chipmunk has one damping for both velocities.
    body->w += turning * (std::exp(-tag.angular_damping * dt) - kept);
  }

  Load load(std::size_t index) {
    if (!loads_.any()) return {};
    if (step_loads_.empty()) step_loads_ = loads_.at(*this);
    return step_loads_[index];
  }

  // Both bodies of a pair list it: it is reported from the first.
  static void append(cpBody* body, cpArbiter* arbiter, void* data) {
    if (arbiter->body_a != body) return;
    auto& out = *static_cast<std::vector<ContactState>*>(data);
    for (int i = 0; i < arbiter->count; ++i) {
      const cpContact& contact = arbiter->contacts[i];
      const cpVect on_a = cpvadd(arbiter->body_a->p, contact.r1);
      const cpVect on_b = cpvadd(arbiter->body_b->p, contact.r2);
      out.push_back({tag_of(arbiter->body_a).index, tag_of(arbiter->body_b).index, from_cp(cpvlerp(on_a, on_b, 0.5)),
                     from_cp(arbiter->n), contact.jnAcc, contact.jtAcc, cpvdot(cpvsub(on_b, on_a), arbiter->n)});
    }
  }

  Loads loads_;
  std::span<const Load> step_loads_;  // of this step; empty until needed
  Mixing mixing_;
  double extent_;                 // m
  std::deque<Tag> tags_;          // bodies point into it
  std::deque<Surface> surfaces_;  // shapes point into it
  std::vector<Owned<cpBody>> bodies_;
  std::vector<Owned<cpShape>> shapes_;
  std::vector<Owned<cpConstraint>> constraints_;
  Owned<cpSpace> space_;  // destroyed first: it touches its bodies
};

std::string unsupported(const Scene& scene, const Settings&) {
  for (const Body& body : scene.bodies) {
    if (body.bullet) return "has no continuous collision, which bullet \"" + body.name + "\" asks for";
  }
  for (const Joint& joint : scene.joints) {
    const auto* slider = std::get_if<Prismatic>(&joint);
    if (slider == nullptr) continue;
    if (slider->motor) return "has motors that turn, and none that slide";
    if (slider->limits && slider->limits->low == slider->limits->high) return "has no grooves without length";
  }
  return common_refusal(scene);
}

const Engine& self() { return *Catalog<Engine>::find("chipmunk"); }

Stepping stepping(const Settings& given, double dt) {
  const Settings settings = complete(self(), given);
  Stepping stated;
  stated.dt = dt;
  stated.h = dt;
  stated.drift = -0.5;
  stated.order = 1;
  stated.order_in_contact = 1;
  stated.impact_lag = 1;
  // No skin: a contact exists from touching on, and its arms end on the bodies' own surfaces.
  stated.slop = std::stod(settings.at("slop"));
  // A joint is held by velocities: what it falls in a step before the impulses of the last one hold it.
  stated.joint_slop = standard_gravity * dt * dt;
  stated.creep = 0;  // friction bounds the sum of the impulses, and can hold a body completely
  stated.restitution_threshold = 0;
  stated.iterations = whole_number(settings, "iterations");
  stated.epsilon = std::ldexp(1.0, -53);
  stated.whole_impulses = false;
  stated.spring_limit = 2;  // v += a(x') dt after x' = x + v dt: symplectic Euler with v half a step behind
  return stated;
}

// A library with assertions prints a greeting to standard output when its first space is made. We make one here, with
// the output redirected, so that no report starts with it.
void swallow_greeting() {
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

const std::vector<std::string> caveats{
    "positions move first, with the old velocities; then velocities are updated and contacts solved at the new "
    "positions",
    "nothing pushes until bodies overlap by the collision slop (option slop): bodies that start apart may come to rest "
    "that deep",
    "overlap is removed slowly, a tenth of it per 1/60 s",
    "no continuous collision: fast bodies pass through thin ones, and a scene with a bullet is not supported",
    "joints are held by velocities and a bias alone, without projection: they yield a little and recover",
    "a soft distance joint is an explicit spring with a damper of its own",
    "contact impulses are not sums over the step: the first touch after a separation still includes what the pair "
    "carried when it last touched",
    "Debian's build has assertions compiled in, which cost time",
    "sleeping is off by default"};

Engine chipmunk() {
  swallow_greeting();
  return {
      .name = "chipmunk",
      .about = "Chipmunk 7: accumulated impulses, positions before velocities, double",
      .source = std::string("Chipmunk2D ") + cpVersionString + ", Scott Lembcke, chipmunk-physics.net",
      .caveats = caveats,
      .options =
          {
              {.key = "iterations",
               .value = "10",
               .about = "iterations of the solver",
               .min = 1,
               .max = 10000,
               .whole = true},
              {.key = "slop",
               .value = "0.005",
               .about = "m, overlap that is left alone; the library's own default is 0.1",
               .min = 0,
               .max = 1},
              sleep_option(),
          },
      .also = {{{"slop", "0.1"}}},
      .ladders = {{.option = "iterations", .values = {"5", "10", "20"}}},
      .stepping = stepping,
      .unsupported = unsupported,
      .build = [](const Scene& scene, const Settings& settings) -> std::unique_ptr<Simulation> {
        return on_paths(scene, std::make_unique<Chipmunk>(scene, complete(self(), settings)));
      },
      .in_process = true,
  };
}

const Catalog<Engine>::Entry entry{chipmunk};

}  // namespace
}  // namespace plumb
