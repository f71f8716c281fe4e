#include "reference/adapters/impulse_world.h"

#include <impulse/impulse.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "reference/adapter.h"

namespace plumb::IMPULSE_PRECISION {
namespace {

using impulse::Real;

impulse::Vec2 to_engine(Vec v) { return {static_cast<Real>(v.x), static_cast<Real>(v.y)}; }
Vec from_engine(impulse::Vec2 v) { return {v.x, v.y}; }

std::optional<impulse::Motor> engine_motor(const std::optional<Motor>& motor) {
  if (!motor) return std::nullopt;
  return impulse::Motor{static_cast<Real>(motor->speed), static_cast<Real>(motor->strength)};
}

std::optional<impulse::Limits> engine_limits(const std::optional<Limits>& limits) {
  if (!limits) return std::nullopt;
  return impulse::Limits{static_cast<Real>(limits->low), static_cast<Real>(limits->high)};
}

struct ShapeOf {
  impulse::Shape operator()(const Circle& circle) const {
    return impulse::Shape::circle(static_cast<Real>(circle.radius), to_engine(circle.center));
  }
  impulse::Shape operator()(const Box& box) const {
    return impulse::Shape::box(to_engine({box.size.x / 2, box.size.y / 2}), to_engine(box.center),
                               static_cast<Real>(box.angle));
  }
  impulse::Shape operator()(const Polygon& polygon) const {
    return impulse::Shape::polygon(converted(polygon.vertices, to_engine));
  }
  impulse::Shape operator()(const Capsule& capsule) const {
    return impulse::Shape::capsule(to_engine(capsule.from), to_engine(capsule.to), static_cast<Real>(capsule.radius));
  }
  impulse::Shape operator()(const Segment& segment) const {
    return impulse::Shape::segment(to_engine(segment.from), to_engine(segment.to));
  }
  impulse::Shape operator()(const HalfSpace& half_space) const {
    return impulse::Shape::half_space(to_engine(half_space.normal), static_cast<Real>(half_space.offset));
  }
};

impulse::BodyDef def_of(const Body& body) {
  impulse::BodyDef def;
  def.type = body_type(body.type, impulse::BodyType::fixed, impulse::BodyType::kinematic, impulse::BodyType::dynamic);
  def.position = to_engine(body.position);
  def.angle = static_cast<Real>(body.angle);
  def.velocity = to_engine(body.velocity);
  def.angular_velocity = static_cast<Real>(body.angular_velocity);
  def.gravity_scale = static_cast<Real>(body.gravity_scale);
  def.linear_damping = static_cast<Real>(body.linear_damping);
  def.angular_damping = static_cast<Real>(body.angular_damping);
  def.fixed_rotation = body.fixed_rotation;
  def.bullet = body.bullet;
  def.layers = body.shapes.empty() ? 0 : body.layers;
  return def;
}

// The engine has no bodies without a shape: a fixed or kinematic body that only anchors joints becomes a disc on no
// layer.
std::vector<impulse::Part> parts_of(const Body& body) {
  if (body.shapes.empty() && body.type != BodyType::dynamic) return {{impulse::Shape::circle(1), {}}};
  std::vector<impulse::Part> parts;
  for (const Shape& shape : body.shapes) {
    const Surface& surface = shape.surface;
    parts.push_back({visit_supported(ShapeOf{}, shape.geometry),
                     {static_cast<Real>(surface.density), static_cast<Real>(surface.static_friction),
                      static_cast<Real>(surface.dynamic_friction), static_cast<Real>(surface.restitution)}});
  }
  return parts;
}

impulse::Continuous continuous_of(const std::string& name) {
  if (name == "off") return impulse::Continuous::off;
  return name == "on" ? impulse::Continuous::on : impulse::Continuous::automatic;
}

impulse::Settings engine_settings(const Settings& settings) {
  impulse::Settings made;
  made.solver = settings.at("solver");
  made.integrator = settings.at("integrator");
  made.broad_phase = settings.at("broad-phase");
  made.iterations = whole_number(settings, "iterations");
  made.position_iterations = whole_number(settings, "position-iterations");
  made.substeps = whole_number(settings, "substeps");
  made.workers = whole_number(settings, "workers");
  made.contacts = settings.at("contacts") == "on";
  made.continuous = continuous_of(settings.at("continuous"));
  made.sleeping = settings.at("sleeping") == "on";
  return made;
}

// The enumerations of mixing rules are the same in scene and engine, in the same order.
impulse::Settings engine_settings(const Scene& scene, const Settings& settings) {
  impulse::Settings made = engine_settings(settings);
  made.gravity = to_engine(scene.gravity);
  made.friction_mixing = static_cast<impulse::FrictionMixing>(scene.mixing.friction);
  made.restitution_mixing = static_cast<impulse::RestitutionMixing>(scene.mixing.restitution);
  return made;
}

class Impulse : public Simulation {
 public:
  Impulse(const Scene& scene, const Settings& settings) : world_(engine_settings(scene, settings)) {
    for (const Body& body : scene.bodies) {
      const impulse::BodyId id = world_.create_body(def_of(body), parts_of(body));
      bodies_.push_back(id);
      if (id.index >= scene_index_.size()) scene_index_.resize(id.index + 1);
      scene_index_[id.index] = bodies_.size() - 1;
    }
    for (const Joint& joint : scene.joints) {
      world_.create_joint(visit_supported([&](const auto& kind) -> impulse::Joint { return joint_of(kind); }, joint));
    }
    for (const Force& force : scene.forces) {
      world_.add_force(std::visit([&](const auto& kind) { return force_of(kind); }, force));
    }
  }

  void step(double dt) override {
    const Real h = static_cast<Real>(dt);
    if (h != world_.dt()) world_.set_dt(h);
    world_.step();
  }

  void drive(std::size_t body, Vec velocity) override {
    impulse::Body driven = world_.body(bodies_[body]);
    driven.set_velocity(to_engine(velocity), driven.angular_velocity());
  }

  void read(std::span<BodyState> out) const override {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const impulse::Body body = world_.body(bodies_[i]);
      out[i] = {from_engine(body.center()), body.angle(), from_engine(body.velocity()), body.angular_velocity()};
    }
  }

  void read_contacts(std::vector<ContactState>& out) const override {
    for (const impulse::ContactInfo& contact : world_.contacts()) {
      out.push_back({scene_index_[contact.a.index], scene_index_[contact.b.index], from_engine(contact.point),
                     from_engine(contact.normal), contact.normal_impulse, contact.tangent_impulse, contact.separation});
    }
  }

 private:
  impulse::Joint joint_of(const Revolute& joint) const {
    impulse::RevoluteJoint made{bodies_[joint.a], bodies_[joint.b], to_engine(joint.anchor)};
    made.limits = engine_limits(joint.limits);
    made.motor = engine_motor(joint.motor);
    return made;
  }

  impulse::Joint joint_of(const Distance& joint) const {
    return impulse::DistanceJoint{bodies_[joint.a],
                                  bodies_[joint.b],
                                  to_engine(joint.anchor_a),
                                  to_engine(joint.anchor_b),
                                  static_cast<Real>(joint.length),
                                  static_cast<Real>(joint.stiffness),
                                  static_cast<Real>(joint.damping)};
  }

  impulse::Joint joint_of(const Prismatic& joint) const {
    impulse::PrismaticJoint made{bodies_[joint.a], bodies_[joint.b], to_engine(joint.anchor), to_engine(joint.axis)};
    made.limits = engine_limits(joint.limits);
    made.motor = engine_motor(joint.motor);
    return made;
  }

  impulse::Joint joint_of(const Weld& joint) const {
    return impulse::WeldJoint{bodies_[joint.a], bodies_[joint.b], to_engine(joint.anchor)};
  }

  impulse::Force force_of(const Attraction& attraction) const {
    impulse::Attraction made;
    made.from = bodies_[attraction.from];
    made.strength = static_cast<Real>(attraction.strength);
    made.exponent = static_cast<Real>(attraction.exponent);
    made.mutual = attraction.mutual;
    return made;
  }

  impulse::Force force_of(const Spring& spring) const {
    impulse::Spring made;
    if (spring.a) made.a = bodies_[*spring.a];
    made.b = bodies_[spring.b];
    made.anchor_a = to_engine(spring.anchor_a);
    made.anchor_b = to_engine(spring.anchor_b);
    made.stiffness = static_cast<Real>(spring.stiffness);
    made.length = static_cast<Real>(spring.length);
    made.damping = static_cast<Real>(spring.damping);
    return made;
  }

  impulse::Force force_of(const Constant& constant) const {
    return impulse::ConstantForce{bodies_[constant.body], to_engine(constant.force),
                                  static_cast<Real>(constant.torque)};
  }

  mutable impulse::World world_;  // mutable because a view of a body can write as well as read
  std::vector<impulse::BodyId> bodies_;
  std::vector<std::size_t> scene_index_;  // by BodyId::index
};

std::vector<std::pair<std::string, std::string>> choices(const std::vector<impulse::MethodInfo>& methods) {
  std::vector<std::pair<std::string, std::string>> made;
  made.reserve(methods.size());
  for (const impulse::MethodInfo& method : methods) made.emplace_back(method.name, method.about + "; " + method.source);
  return made;
}

std::vector<Option> options() {
  const impulse::Settings standard;
  return {{.key = "solver",
           .value = standard.solver,
           .choices = choices(impulse::solvers()),
           .about = "method that solves contacts"},
          {.key = "integrator",
           .value = standard.integrator,
           .choices = choices(impulse::integrators()),
           .about = "method that integrates free motion, for solvers that leave the choice"},
          {.key = "broad-phase",
           .value = standard.broad_phase,
           .choices = choices(impulse::broad_phases()),
           .about = "method that finds pairs of bodies"},
          {.key = "iterations",
           .value = std::to_string(standard.iterations),
           .about = "iterations of the velocity solver",
           .min = 1,
           .max = 10000,
           .whole = true},
          {.key = "position-iterations",
           .value = std::to_string(standard.position_iterations),
           .about = "iterations of solvers that correct positions separately from velocities",
           .min = 0,
           .max = 10000,
           .whole = true},
          {.key = "substeps",
           .value = std::to_string(standard.substeps),
           .about = "sub-steps of a step, for solvers that split it",
           .min = 1,
           .max = 1000,
           .whole = true},
          {.key = "contacts",
           .value = standard.contacts ? "on" : "off",
           .choices = {{"on", "bodies collide"}, {"off", "bodies pass through each other, and no pairs are searched"}},
           .about = "contacts between bodies"},
          {.key = "continuous",
           .value = "auto",
           .choices = {{"off",
                        "a body passes through anything thinner than its displacement in a step, unless the solver "
                        "looks ahead"},
                       {"auto",
                        "a body that moves more than half its thickness in a step stops where it meets a fixed or "
                        "kinematic body, a bullet where it meets any body; conservative advancement, B. Mirtich "
                        "(1996)"},
                       {"on", "as if every body were a bullet"}},
           .about = "continuous collision"},
          {.key = "workers",
           .value = std::to_string(standard.workers),
           .about = "threads; the result is the same to the bit for any number",
           .min = 1,
           .max = 256,
           .whole = true},
          {.key = "sleeping",
           .value = standard.sleeping ? "on" : "off",
           .choices = {{"off", "every body is solved in every step: a sleeping stack would have perfect energy"},
                       {"on", "islands at rest for half a second are not solved until something disturbs them"}},
           .about = "sleeping of islands at rest"}};
}

// Explicit Euler multiplies a spring's energy by 1 + (w h)^2; the fourth-order Runge-Kutta polynomial is within the
// unit circle up to w h = 2 sqrt 2 on the imaginary axis; symplectic Euler and Verlet have the trace 2 - (w h)^2 and
// the determinant 1. Forces are evaluated in every sub-step. (Hairer, Lubich, Wanner 2006, I.1; Hairer, Wanner 1996,
// IV.2)
double spring_limit(const impulse::StatedErrors& errors, double dt) {
  if (errors.drift < 0) return 0;
  return (errors.order == 4 ? 2 * std::numbers::sqrt2 : 2) * std::round(dt / errors.h);
}

Stepping stepping(const Settings& settings, double dt) {
  impulse::Settings with_dt = engine_settings(settings);
  with_dt.dt = static_cast<Real>(dt);
  const impulse::StatedErrors errors = impulse::stated_errors(with_dt);
  Stepping stated;
  stated.dt = dt;
  stated.h = errors.h;
  stated.drift = errors.drift;
  stated.order = errors.order;
  stated.order_in_contact = errors.order_in_contact;
  stated.impact_lag = errors.impact_lag;
  // Without a skin. But what pushes overlap out, a bias or a spring, may overshoot by as much as it pushes out.
  stated.skin = stated.slop = errors.gap;
  stated.joint_slop = errors.joint_gap;
  stated.creep = errors.creep;
  stated.iterations = errors.impact_lag > 0 ? with_dt.iterations : 0;
  stated.rest_speed = with_dt.sleeping ? with_dt.sleep_linear_speed : 0;
  stated.restitution_threshold = errors.restitution_threshold;
  stated.epsilon = std::numeric_limits<Real>::epsilon() / 2;
  stated.looks_ahead = errors.looks_ahead;
  stated.spring_limit = spring_limit(errors, dt);
  return stated;
}

// The engine's own message if it refuses a shape, which it checks as it makes it; "" if it takes all.
std::string shape_refusal(const Scene& scene) {
  try {
    for (const Body& body : scene.bodies) parts_of(body);
  } catch (const std::invalid_argument& refused) {
    return refused.what();
  }
  return "";
}

std::string unsupported(const Scene& scene, const Settings& settings) {
  if (!scene.joints.empty() && !impulse::stated_errors(engine_settings(scene, settings)).joints) {
    return "its solver " + settings.at("solver") + " does not support joints";
  }
  std::string reason = kind_refusal(scene);
  if (reason.empty()) reason = moving_half_space_refusal(scene);
  if (reason.empty()) reason = massless_refusal(scene);
  return reason.empty() ? shape_refusal(scene) : reason;
}

std::unique_ptr<Simulation> build(const Scene& scene, const Settings& settings) {
  return on_paths(scene, std::make_unique<Impulse>(scene, settings));
}

}  // namespace

ImpulseEngine impulse_engine() { return {options, stepping, unsupported, build}; }

}  // namespace plumb::IMPULSE_PRECISION
