// What this engine does differently is in `caveats`. Besides:
// - Collisions are found once a step, a little ahead ("speculative"). From 3.2 on, contacts that hardly changed are
//   recycled, which stacks need.
// - Rotations are stored as cosine and sine. We start them from exact values (b2MakeRot is an approximation), and count
//   whole turns from one reading to the next.
// - One coefficient of friction. It is mixed by a callback that gets only the coefficients, so there is one per rule.
// - Joints are stiff springs too, soft ones tuned by frequency: see box2d_v3/joints.cpp.
// - No half-spaces: we build them from a segment (see HalfSpaceEdge).
// - Contact impulses: see normal_impulse; the tangential ones are in proportion to the last sub-step's.
// The origin of every body is moved to its centre of mass; mass and inertia come from plumb::mass_of. Fields that 3.1
// and 3.2 name differently are told apart by `requires`.

#include <box2d/box2d.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <mutex>
#include <numbers>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "reference/adapter.h"
#include "reference/adapters/box2d_v3/joints.h"
#include "reference/scene_facts.h"
#include "reference/simulation.h"
#include "scenarios/scene/mass.h"

namespace plumb {
namespace {

using namespace box2d_v3;

// The ids are not needed. Their type changed with 3.2.
template <FrictionMixing rule, class Id>
float mixed_friction(float a, Id, float b, Id) {
  return static_cast<float>(
      mixed_dynamic_friction({.friction = rule}, {.dynamic_friction = a}, {.dynamic_friction = b}));
}

template <RestitutionMixing rule, class Id>
float mixed_bounce(float a, Id, float b, Id) {
  return static_cast<float>(mixed_restitution({.restitution = rule}, {.restitution = a}, {.restitution = b}));
}

b2FrictionCallback* callback_of(FrictionMixing rule) {
  switch (rule) {
    case FrictionMixing::geometric:
      return mixed_friction<FrictionMixing::geometric>;
    case FrictionMixing::pythagorean:
      return mixed_friction<FrictionMixing::pythagorean>;
    case FrictionMixing::average:
      return mixed_friction<FrictionMixing::average>;
    case FrictionMixing::min:
      return mixed_friction<FrictionMixing::min>;
    case FrictionMixing::max:
      return mixed_friction<FrictionMixing::max>;
    case FrictionMixing::multiply:
      return mixed_friction<FrictionMixing::multiply>;
  }
  return nullptr;
}

b2RestitutionCallback* callback_of(RestitutionMixing rule) {
  switch (rule) {
    case RestitutionMixing::max:
      return mixed_bounce<RestitutionMixing::max>;
    case RestitutionMixing::min:
      return mixed_bounce<RestitutionMixing::min>;
    case RestitutionMixing::average:
      return mixed_bounce<RestitutionMixing::average>;
    case RestitutionMixing::multiply:
      return mixed_bounce<RestitutionMixing::multiply>;
  }
  return nullptr;
}

b2Hull hull_of(const std::vector<Vec>& given) {
  const std::vector<b2Vec2> vertices = converted(given, to_b2);
  return b2ComputeHull(vertices.data(), static_cast<int>(vertices.size()));
}

// Attaches the shapes of the scene to a Box2D body.
struct AttachShape {
  b2BodyId body;
  b2ShapeDef def;

  void operator()(const Circle& circle) const {
    const b2Circle made{to_b2(circle.center), static_cast<float>(circle.radius)};
    b2CreateCircleShape(body, &def, &made);
  }
  void operator()(const Box& box) const {
    const b2Polygon made = b2MakeOffsetBox(static_cast<float>(box.size.x / 2), static_cast<float>(box.size.y / 2),
                                           to_b2(box.center), rotation_by(box.angle));
    b2CreatePolygonShape(body, &def, &made);
  }
  void operator()(const Polygon& polygon) const {
    const b2Hull hull = hull_of(polygon.vertices);
    const b2Polygon made = b2MakePolygon(&hull, 0);
    b2CreatePolygonShape(body, &def, &made);
  }
  void operator()(const Capsule& capsule) const {
    const b2Capsule made{to_b2(capsule.from), to_b2(capsule.to), static_cast<float>(capsule.radius)};
    b2CreateCapsuleShape(body, &def, &made);
  }
  void operator()(const Segment& segment) const {
    const b2Segment made{to_b2(segment.from), to_b2(segment.to)};
    b2CreateSegmentShape(body, &def, &made);
  }
  void operator()(const HalfSpace&) const {}  // has a body of its own
};

// All worlds of the program live in one table that Box2D does not guard.
std::mutex& table() {
  static std::mutex guard;
  return guard;
}

class World {
 public:
  explicit World(const b2WorldDef& def) {
    const std::lock_guard<std::mutex> lock(table());
    id_ = b2CreateWorld(&def);
    if (!b2World_IsValid(id_)) throw std::runtime_error("box2d-v3: no more worlds");
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World() {
    const std::lock_guard<std::mutex> lock(table());
    b2DestroyWorld(id_);
  }
  b2WorldId id() const { return id_; }

 private:
  b2WorldId id_{};
};

b2WorldDef world_of(const Scene& scene, const Settings& settings) {
  b2WorldDef def = b2DefaultWorldDef();
  def.gravity = to_b2(scene.gravity);
  def.restitutionThreshold = std::stof(settings.at("restitution"));
  def.frictionCallback = callback_of(scene.mixing.friction);
  def.restitutionCallback = callback_of(scene.mixing.restitution);
  def.enableSleep = settings.at("sleep") == "on";
  def.enableContinuous = settings.at("continuous") == "on";
  def.workerCount = whole_number(settings, "workers");
  return def;
}

// Whether totalNormalImpulse is the impulse of the step, as it is since #1022. Before, it is the sum of what was
// reached after solving and after relaxing, twice the weight at rest. The same change gave this callback its size.
template <class Free>
constexpr bool totals_are_impulses() {
  return requires(Free * free_memory) { free_memory(nullptr, 0u); };
}

// The normal impulse over the whole step; of older versions only what the last sub-step's would make of it, or what the
// larger total bounds it by, as in an impact, whose restitution acts once in a step.
double normal_impulse(const b2ManifoldPoint& at, int substeps) {
  const double total = at.totalNormalImpulse;
  return totals_are_impulses<b2FreeFcn>() ? total : std::min(total, substeps * double{at.normalImpulse});
}

class Box2dV3 : public Simulation {
 public:
  Box2dV3(const Scene& scene, const Settings& settings)
      : loads_(scene), world_(world_of(scene, settings)), substeps_(whole_number(settings, "substeps")) {
    b2World_EnableWarmStarting(world_.id(), settings.at("warm") == "on");
    const double extent = scene_extent(scene);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) add(i, scene.bodies[i], extent);
    add_joints(world_.id(), scene, bodies_);
  }

  void step(double dt) override {
    if (loads_.any()) apply_loads(dt);
    b2World_Step(world_.id(), static_cast<float>(dt), substeps_);
    since_reading_ += dt;
  }

  void drive(std::size_t body, Vec velocity) override { b2Body_SetLinearVelocity(bodies_[body], to_b2(velocity)); }

  void read(std::span<BodyState> out) const override {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const b2BodyId body = bodies_[i];
      const double w = b2Body_GetAngularVelocity(body);
      out[i] = {from_b2(b2Body_GetPosition(body)), unwound(i, w), from_b2(b2Body_GetLinearVelocity(body)), w};
    }
    since_reading_ = 0;
  }

  void read_contacts(std::vector<ContactState>& out) const override {
    for (const b2BodyId body : carriers_) append(body, out);
  }

 private:
  static std::size_t index_of(b2BodyId body) { return *static_cast<const std::size_t*>(b2Body_GetUserData(body)); }

  void add(std::size_t index, const Body& given, double extent) {
    const Body body = centered(given);
    const b2BodyId made = make(index, body, body.angle);
    bodies_.push_back(made);
    angles_.push_back(body.angle);
    for (const Shape& shape : body.shapes) {
      const b2ShapeDef def = shape_of(body, shape.surface);
      if (const auto* half_space = std::get_if<HalfSpace>(&shape.geometry)) {
        const HalfSpaceEdge edge = edge_of(body, *half_space, extent);
        const AttachShape attach{make(index, body, edge.angle), def};
        attach(edge.segment);
      } else {
        visit_supported(AttachShape{made, def}, shape.geometry);
      }
    }
    if (body.type != BodyType::dynamic) return;
    const Mass mass = mass_of(given);
    b2Body_SetMassData(made, {static_cast<float>(mass.mass), {0, 0}, static_cast<float>(mass.inertia)});
    b2Body_SetLinearVelocity(made, to_b2(body.velocity));  // each shape shifted the centre of mass, and the velocity
  }

  b2BodyId make(std::size_t index, const Body& body, double angle) {
    b2BodyDef def = b2DefaultBodyDef();
    def.type = body_type(body.type, b2_staticBody, b2_kinematicBody, b2_dynamicBody);
    def.position.x = static_cast<decltype(def.position.x)>(body.position.x);
    def.position.y = static_cast<decltype(def.position.y)>(body.position.y);
    def.rotation = rotation_by(angle);
    def.linearVelocity = to_b2(body.velocity);
    def.angularVelocity = static_cast<float>(body.angular_velocity);
    def.linearDamping = static_cast<float>(body.linear_damping);
    def.angularDamping = static_cast<float>(body.angular_damping);
    def.gravityScale = static_cast<float>(body.gravity_scale);
    def.isBullet = body.bullet;
    def.userData = &indices_.emplace_back(index);
    return carriers_.emplace_back(b2CreateBody(world_.id(), &def));
  }

  static b2ShapeDef shape_of(const Body& body, const Surface& surface) {
    b2ShapeDef def = b2DefaultShapeDef();
    def.density = static_cast<float>(surface.density);
    def.material.friction = static_cast<float>(surface.dynamic_friction);
    def.material.restitution = static_cast<float>(surface.restitution);
    def.filter.categoryBits = body.layers;
    def.filter.maskBits = body.layers;
    return def;
  }

  // Held over the step: those of where the sub-steps begin on average, as if each had its own.
  void apply_loads(double dt) {
    const std::span<const Load> loads = loads_.at(*this, (1 - 1.0 / substeps_) / 2 * dt);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      b2Body_ApplyForceToCenter(bodies_[i], to_b2(loads[i].force), true);
      b2Body_ApplyTorque(bodies_[i], static_cast<float>(loads[i].torque), true);
    }
  }

  // The angle of the rotation that is nearest to the last reading extrapolated by the present angular velocity.
  double unwound(std::size_t i, double w) const {
    const b2Rot turn = b2Body_GetRotation(bodies_[i]);
    const double expected = angles_[i] + w * since_reading_;
    const double off = std::atan2(double{turn.s}, double{turn.c}) - expected;
    angles_[i] = expected + std::remainder(off, 2 * std::numbers::pi);
    return angles_[i];
  }

  // Both bodies of a contact list it: it is reported from the first.
  void append(b2BodyId body, std::vector<ContactState>& out) const {
    std::vector<b2ContactData> contacts(static_cast<std::size_t>(b2Body_GetContactCapacity(body)));
    const int count = b2Body_GetContactData(body, contacts.data(), static_cast<int>(contacts.size()));
    for (int i = 0; i < count; ++i) {
      const b2ContactData& contact = contacts[static_cast<std::size_t>(i)];
      if (!B2_ID_EQUALS(b2Shape_GetBody(contact.shapeIdA), body)) continue;
      const Vec origin = from_b2(b2Body_GetPosition(body));
      const b2Manifold& manifold = contact.manifold;
      for (int p = 0; p < manifold.pointCount; ++p) {
        const b2ManifoldPoint& at = manifold.points[p];
        const double normal = normal_impulse(at, substeps_);
        // Box2D's tangent is the normal turned by -90 degrees.
        const double tangent = at.normalImpulse > 0 ? -normal * at.tangentImpulse / at.normalImpulse : 0;
        out.push_back({index_of(body),
                       index_of(b2Shape_GetBody(contact.shapeIdB)),
                       {origin.x + at.anchorA.x, origin.y + at.anchorA.y},
                       from_b2(manifold.normal),
                       normal,
                       tangent,
                       at.separation});
      }
    }
  }

  Loads loads_;
  std::deque<std::size_t> indices_;  // bodies point into it
  World world_;
  std::vector<b2BodyId> bodies_;        // one for each of the scene
  std::vector<b2BodyId> carriers_;      // those and one for each half-space
  mutable std::vector<double> angles_;  // rad, as last read
  mutable double since_reading_ = 0;    // s
  int substeps_;
};

struct Refusal {
  std::string operator()(const Polygon& polygon) const {
    if (polygon.vertices.size() > B2_MAX_POLYGON_VERTICES) return "polygons have at most eight vertices";
    const bool whole = hull_of(polygon.vertices).count == static_cast<int>(polygon.vertices.size());
    return whole ? "" : "drops vertices within 0.01 m of a line through others";
  }
  template <class Other>
  std::string operator()(const Other&) const {
    return "";
  }
};

std::string unsupported(const Scene& scene, const Settings&) {
  std::string reason = common_refusal(scene);
  if (reason.empty()) reason = eccentric_spring_refusal(scene);
  return reason.empty() ? geometry_refusal(scene, Refusal{}) : reason;
}

const Engine& self() { return *Catalog<Engine>::find("box2d-v3"); }

// A force is held over the n sub-steps of a step: with k = w dt and V = v dt, V' = V - k^2 y, x' = x + V - (1 + 1/n)/2
// k^2 y. At y = x a spring would gain energy; at y = x + (1 - 1/n)/2 V, where the sub-steps begin on average, the
// determinant is 1 and the trace 2 - k^2, as for symplectic Euler, so that it is bounded up to k = 2.
Stepping stepping(const Settings& given, double dt) {
  const Settings settings = complete(self(), given);
  Stepping stated;
  stated.dt = dt;
  stated.h = dt / std::stod(settings.at("substeps"));
  stated.drift = 0.5;
  stated.order = 1;
  // Impacts are found once a step, and bounce at the end of the step that finds them.
  stated.impact_lag = 2 * std::stod(settings.at("substeps"));
  // The relaxation that ends a step brakes what would touch within a sub-step more.
  stated.impact_lead = 1;
  // Shapes have no skin, and contacts are springs of the lesser of 30 Hz and an eighth of the sub-step's rate, twice
  // that on fixed bodies (b2World_Step). The slop is their depth under one weight, 2.5 g/w^2 for a square on its like
  // (two corners, each with half the weight and an effective mass of m/5). Joints are springs of twice that frequency.
  stated.contact_frequency = std::min(30.0, 0.125 / stated.h);
  stated.fixed_contact_frequency = 2 * stated.contact_frequency;
  const double contact_omega = 2 * std::numbers::pi * stated.contact_frequency;
  stated.slop = 2.5 * standard_gravity / (contact_omega * contact_omega);
  stated.joint_frequency = 2 * stated.contact_frequency;
  stated.joint_slop = 2.5 * standard_gravity / (4 * contact_omega * contact_omega);
  stated.tangent_rotation = true;  // b2IntegrateRotation
  stated.held_anchors = true;      // its sub-steps turn the arms that the step began with (solve_contact)
  stated.creep = 0;
  stated.iterations = 1;  // restitution is applied once a step
  stated.restitution_threshold = std::stod(settings.at("restitution"));
  stated.epsilon = std::ldexp(1.0, -24);
  stated.whole_impulses = false;
  stated.spring_limit = 2;
  return stated;
}

std::string version() {
  const b2Version version = b2GetVersion();
  return std::to_string(version.major) + "." + std::to_string(version.minor) + "." + std::to_string(version.revision);
}

// B2_LINEAR_SLOP is a tolerance of finding contacts (contact_solver.c); hulls are simplified in hull.c.
const std::vector<std::string> caveats{
    "float arithmetic, with double positions if it was built so",
    "contacts and joints are damped springs, contacts of 30 Hz or 60 Hz on fixed bodies: they do not converge with the "
    "step, and a load presses boxes a few millimetres into each other",
    "nothing bounces below a closing speed of 1 m/s (option restitution)",
    "restitution acts once, at the end of the step, without friction, which takes mu m v from an impact that slips, "
    "not mu (1 "
    "+ e) m v",
    "rotations advance by atan(w h): fast spins lose (w h)^2/3 of their angle",
    "damping c divides velocities by 1 + c h each sub-step; the scene means e^(-c h)",
    "nothing moves faster than 400 m/s or turns by more than an eighth turn in a sub-step",
    "vertices within 0.01 m of a line through others are dropped; polygons have at most eight",
    "sleeping is off by default"};

const Catalog<Engine>::Entry entry{{
    .name = "box2d-v3",
    .about = "Box2D 3: soft contacts in sub-steps, float",
    .source = "Box2D " + version() + ", Erin Catto, box2d.org",
    .caveats = caveats,
    .options =
        {
            {.key = "substeps", .value = "4", .about = "sub-steps of a step", .min = 1, .max = 1000, .whole = true},
            restitution_threshold_option(),
            continuous_option(),
            sleep_option(),
            {.key = "workers",
             .value = "1",
             .about = "threads; ignored before 3.2, which uses one",
             .min = 1,
             .max = 64,
             .whole = true},
            warm_start_option(),
        },
    .ladders = {{.option = "substeps", .values = {"1", "2", "4", "8"}}},
    .stepping = stepping,
    .unsupported = unsupported,
    .build = [](const Scene& scene, const Settings& settings) -> std::unique_ptr<Simulation> {
      return on_paths(scene, std::make_unique<Box2dV3>(scene, complete(self(), settings)));
    },
    .in_process = true,
}};

}  // namespace
}  // namespace plumb
