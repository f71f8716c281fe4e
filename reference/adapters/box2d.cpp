// What this engine does differently is in `caveats`. Besides:
// - One coefficient of friction. We mix the coefficients and set them on each contact when it begins.
// - No capsules: we build them from two circles and a rectangle, thinned by its skin so that sides and caps are flush.
// - No half-spaces: we build them from an edge (see HalfSpaceEdge). An edge has two sides; continuous collision keeps
//   bodies from passing through. (A large box gives the same results.)
// The origin of every body is moved to its centre of mass; mass and inertia come from plumb::mass_of.

#include <box2d/box2d.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "reference/adapter.h"
#include "reference/adapters/box2d_joints.h"
#include "reference/scene_facts.h"
#include "reference/simulation.h"
#include "scenarios/scene/mass.h"

namespace plumb {
namespace {

b2Vec2 to_b2(Vec v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }
Vec from_b2(b2Vec2 v) { return {v.x, v.y}; }

// What a fixture keeps from the scene. The user data of a fixture is an index into a list of these.
struct Tag {
  std::size_t body = 0;
  std::uint32_t layers = 0;
  Surface surface;
};

class Tags {
 public:
  b2FixtureUserData add(Tag tag) {
    tags_.push_back(tag);
    b2FixtureUserData data;
    data.pointer = tags_.size() - 1;
    return data;
  }
  // const_cast because b2Fixture::GetUserData is not const, although it changes nothing.
  const Tag& of(const b2Fixture* fixture) const {
    return tags_[const_cast<b2Fixture*>(fixture)->GetUserData().pointer];
  }

 private:
  std::vector<Tag> tags_;
};

class SharedLayers : public b2ContactFilter {
 public:
  explicit SharedLayers(const Tags& tags) : tags_(tags) {}

 private:
  bool ShouldCollide(b2Fixture* a, b2Fixture* b) override { return (tags_.of(a).layers & tags_.of(b).layers) != 0; }

  const Tags& tags_;
};

// Sets the scene's coefficients when a contact begins; they persist. Collects the impulses after each solve: a step has
// several if continuous collision acts. A sleeping contact is not solved and keeps the impulses of its last step awake.
class Contacts : public b2ContactListener {
 public:
  Contacts(const Tags& tags, Mixing mixing, float threshold) : tags_(tags), mixing_(mixing), threshold_(threshold) {}

  void begin_step(bool may_sleep) {
    if (may_sleep) std::copy_if(solved_.begin(), solved_.end(), std::back_inserter(asleep_), sleeps);
    solved_.clear();
  }
  void end_step() {
    std::erase_if(asleep_, [](const Solved& solved) { return !sleeps(solved); });
  }

  void read(std::vector<ContactState>& out) const {
    append(asleep_, out);
    append(solved_, out);
  }

 private:
  struct Solved {
    const b2Contact* contact;
    b2Manifold manifold;  // a copy: a later sub-step may replace the contact's own
    b2WorldManifold met;  // where the impulses acted: before the bodies moved
    b2ContactImpulse impulse;
  };

  static bool sleeps(const Solved& solved) {
    const auto still = [](const b2Body* body) { return body->GetType() == b2_staticBody || !body->IsAwake(); };
    return still(solved.contact->GetFixtureA()->GetBody()) && still(solved.contact->GetFixtureB()->GetBody());
  }

  // Whether a later solve of the step met the contact where an earlier one did, as where a body rests.
  static bool same_points(const Solved& a, const Solved& b) {
    if (a.contact != b.contact || a.impulse.count != b.impulse.count || a.met.normal != b.met.normal) return false;
    return std::equal(a.met.points, a.met.points + a.impulse.count, b.met.points);
  }

  void append(const std::vector<Solved>& all, std::vector<ContactState>& out) const {
    for (const Solved& solved : all) {
      const b2Fixture* a = solved.contact->GetFixtureA();
      const b2Fixture* b = solved.contact->GetFixtureB();
      const b2WorldManifold left = placed(solved.contact, solved.manifold);
      for (int i = 0; i < solved.impulse.count; ++i) {
        // Box2D's tangent is the normal turned by -90 degrees.
        out.push_back({tags_.of(a).body, tags_.of(b).body, from_b2(solved.met.points[i]), from_b2(solved.met.normal),
                       solved.impulse.normalImpulses[i], -solved.impulse.tangentImpulses[i], left.separations[i]});
      }
    }
  }

  static b2WorldManifold placed(const b2Contact* contact, const b2Manifold& manifold) {
    const b2Fixture* a = contact->GetFixtureA();
    const b2Fixture* b = contact->GetFixtureB();
    b2WorldManifold world;
    world.Initialize(&manifold, a->GetBody()->GetTransform(), a->GetShape()->m_radius, b->GetBody()->GetTransform(),
                     b->GetShape()->m_radius);
    return world;
  }

  void BeginContact(b2Contact* contact) override {
    const Surface& a = tags_.of(contact->GetFixtureA()).surface;
    const Surface& b = tags_.of(contact->GetFixtureB()).surface;
    contact->SetFriction(static_cast<float>(mixed_dynamic_friction(mixing_, a, b)));
    contact->SetRestitution(static_cast<float>(mixed_restitution(mixing_, a, b)));
    contact->SetRestitutionThreshold(threshold_);
  }

  void EndContact(b2Contact* contact) override {
    std::erase_if(asleep_, [=](const Solved& solved) { return solved.contact == contact; });
  }

  void PreSolve(b2Contact* contact, const b2Manifold*) override {
    met_[contact] = placed(contact, *contact->GetManifold());
  }

  void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override {
    const Solved now{contact, *contact->GetManifold(), met_.at(contact), *impulse};
    const auto before =
        std::find_if(solved_.begin(), solved_.end(), [&](const Solved& solved) { return same_points(solved, now); });
    if (before == solved_.end()) {
      solved_.push_back(now);
      return;
    }
    for (int i = 0; i < now.impulse.count; ++i) {
      before->impulse.normalImpulses[i] += now.impulse.normalImpulses[i];
      before->impulse.tangentImpulses[i] += now.impulse.tangentImpulses[i];
    }
  }

  const Tags& tags_;
  Mixing mixing_;
  float threshold_;
  std::vector<Solved> solved_;                       // in this step
  std::vector<Solved> asleep_;                       // in an earlier one
  std::map<const b2Contact*, b2WorldManifold> met_;  // only looked up: its order never shows
};

// Attaches the shapes of the scene to a Box2D body.
struct AttachShape {
  b2Body& body;
  b2FixtureUserData tag;

  void operator()(const Circle& circle) { disc(circle.center, circle.radius); }

  void operator()(const Box& box) { rectangle(box.center, box.size.x / 2, box.size.y / 2, box.angle); }

  void operator()(const Polygon& polygon) {
    const std::vector<b2Vec2> vertices = converted(polygon.vertices, to_b2);
    b2PolygonShape shape;
    shape.Set(vertices.data(), static_cast<int32>(vertices.size()));
    create(shape);
  }

  void operator()(const Capsule& capsule) {
    const Vec d{capsule.to.x - capsule.from.x, capsule.to.y - capsule.from.y};
    rectangle({(capsule.from.x + capsule.to.x) / 2, (capsule.from.y + capsule.to.y) / 2}, std::hypot(d.x, d.y) / 2,
              capsule.radius - b2_polygonRadius, std::atan2(d.y, d.x));
    disc(capsule.from, capsule.radius);
    disc(capsule.to, capsule.radius);
  }

  void operator()(const Segment& segment) {
    b2EdgeShape shape;
    shape.SetTwoSided(to_b2(segment.from), to_b2(segment.to));
    create(shape);
  }

  void operator()(const HalfSpace&) {}  // has a body of its own

  void disc(Vec center, double radius) {
    b2CircleShape shape;
    shape.m_p = to_b2(center);
    shape.m_radius = static_cast<float>(radius);
    create(shape);
  }

  void rectangle(Vec center, double half_width, double half_height, double angle) {
    b2PolygonShape shape;
    shape.SetAsBox(static_cast<float>(half_width), static_cast<float>(half_height), to_b2(center),
                   static_cast<float>(angle));
    create(shape);
  }

  void create(const b2Shape& shape) {
    b2FixtureDef def;
    def.userData = tag;
    def.shape = &shape;
    body.CreateFixture(&def);
  }
};

class Box2d : public Simulation {
 public:
  Box2d(const Scene& scene, const Settings& settings)
      : loads_(scene),
        filter_(tags_),
        contacts_(tags_, scene.mixing, std::stof(settings.at("restitution"))),
        world_(to_b2(scene.gravity)),
        velocity_iterations_(whole_number(settings, "velocity")),
        position_iterations_(whole_number(settings, "position")) {
    world_.SetAllowSleeping(settings.at("sleep") == "on");
    world_.SetContinuousPhysics(settings.at("continuous") == "on");
    world_.SetWarmStarting(settings.at("warm") == "on");
    world_.SetContactFilter(&filter_);
    world_.SetContactListener(&contacts_);
    const double extent = scene_extent(scene);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) add(i, scene.bodies[i], extent);
    for (const Joint& joint : scene.joints) {
      visit_supported([&](const auto& kind) { add(kind); }, joint);
    }
  }

  void step(double dt) override {
    if (loads_.any()) apply_loads();
    contacts_.begin_step(world_.GetAllowSleeping());
    world_.Step(static_cast<float>(dt), velocity_iterations_, position_iterations_);
    contacts_.end_step();
  }

  void drive(std::size_t body, Vec velocity) override { bodies_[body]->SetLinearVelocity(to_b2(velocity)); }

  void read(std::span<BodyState> out) const override {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const b2Body& body = *bodies_[i];
      out[i] = {from_b2(body.GetPosition()), body.GetAngle(), from_b2(body.GetLinearVelocity()),
                body.GetAngularVelocity()};
    }
  }

  void read_contacts(std::vector<ContactState>& out) const override { contacts_.read(out); }

 private:
  void add(std::size_t index, const Body& given, double extent) {
    const Body body = centered(given);
    b2Body* made = make(body, body.angle);
    bodies_.push_back(made);
    for (const Shape& shape : body.shapes) {
      const b2FixtureUserData tag = tags_.add({index, body.layers, shape.surface});
      if (const auto* half_space = std::get_if<HalfSpace>(&shape.geometry)) {
        const HalfSpaceEdge edge = edge_of(body, *half_space, extent);
        AttachShape attach{*make(body, edge.angle), tag};
        attach(edge.segment);
      } else {
        AttachShape attach{*made, tag};
        visit_supported(attach, shape.geometry);
      }
    }
    const Mass mass = mass_of(given);
    const b2MassData data{static_cast<float>(mass.mass), {0, 0}, static_cast<float>(mass.inertia)};
    made->SetMassData(&data);
  }

  b2Body* make(const Body& body, double angle) {
    b2BodyDef def;
    def.type = body_type(body.type, b2_staticBody, b2_kinematicBody, b2_dynamicBody);
    def.position = to_b2(body.position);
    def.angle = static_cast<float>(angle);
    def.linearVelocity = to_b2(body.velocity);
    def.angularVelocity = static_cast<float>(body.angular_velocity);
    def.linearDamping = static_cast<float>(body.linear_damping);
    def.angularDamping = static_cast<float>(body.angular_damping);
    def.fixedRotation = body.fixed_rotation;
    def.bullet = body.bullet;
    def.gravityScale = static_cast<float>(body.gravity_scale);
    return world_.CreateBody(&def);
  }

  void add(const Revolute& joint) {
    b2RevoluteJointDef def;
    def.Initialize(bodies_[joint.a], bodies_[joint.b], to_b2(joint.anchor));
    set_limits(def, def.lowerAngle, def.upperAngle, joint.limits);
    set_motor(def, def.maxMotorTorque, joint.motor);
    world_.CreateJoint(&def);
  }

  void add(const Distance& joint) {
    b2DistanceJointDef def;
    def.Initialize(bodies_[joint.a], bodies_[joint.b], to_b2(joint.anchor_a), to_b2(joint.anchor_b));
    const bool rigid = joint.stiffness == 0;
    def.length = static_cast<float>(joint.length);
    def.minLength = rigid ? def.length : 0;
    def.maxLength = rigid ? def.length : b2_maxFloat;
    def.stiffness = static_cast<float>(joint.stiffness);
    def.damping = static_cast<float>(joint.damping);
    world_.CreateJoint(&def);
  }

  void add(const Prismatic& joint) {
    b2PrismaticJointDef def;
    def.Initialize(bodies_[joint.a], bodies_[joint.b], to_b2(joint.anchor), to_b2(joint.axis));
    set_limits(def, def.lowerTranslation, def.upperTranslation, joint.limits);
    set_motor(def, def.maxMotorForce, joint.motor);
    world_.CreateJoint(&def);
  }

  void add(const Weld& joint) {
    b2WeldJointDef def;
    def.Initialize(bodies_[joint.a], bodies_[joint.b], to_b2(joint.anchor));
    world_.CreateJoint(&def);
  }

  void apply_loads() {
    const std::span<const Load> loads = loads_.at(*this);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      bodies_[i]->ApplyForceToCenter(to_b2(loads[i].force), true);
      bodies_[i]->ApplyTorque(static_cast<float>(loads[i].torque), true);
    }
  }

  Loads loads_;
  Tags tags_;
  SharedLayers filter_;
  Contacts contacts_;
  b2World world_;
  std::vector<b2Body*> bodies_;
  int velocity_iterations_;
  int position_iterations_;
};

// b2PolygonShape::Set would weld close vertices, and replace the polygon by a 1 m box if fewer than three are left.
bool welds(const std::vector<Vec>& vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double d = std::hypot(vertices[i].x - vertices[j].x, vertices[i].y - vertices[j].y);
      if (d <= b2_linearSlop / 2) return true;
    }
  }
  return false;
}

struct Refusal {
  std::string operator()(const Polygon& polygon) const {
    if (polygon.vertices.size() > b2_maxPolygonVertices) return "polygons have at most eight vertices";
    return welds(polygon.vertices) ? "welds vertices closer than 0.0025 m" : "";
  }
  std::string operator()(const Capsule& capsule) const {
    const bool thin = capsule.radius <= 2 * b2_polygonRadius;
    return thin ? "has no capsules; one built from a rectangle with a skin needs a radius above 0.02 m" : "";
  }
  template <class Other>
  std::string operator()(const Other&) const {
    return "";
  }
};

std::string unsupported(const Scene& scene, const Settings&) {
  const std::string reason = common_refusal(scene);
  return reason.empty() ? geometry_refusal(scene, Refusal{}) : reason;
}

const Engine& self() { return *Catalog<Engine>::find("box2d"); }

Stepping stepping(const Settings& given, double dt) {
  const Settings settings = complete(self(), given);
  Stepping stated;
  stated.dt = dt;
  stated.h = dt;
  stated.drift = 0.5;
  stated.order = 1;
  stated.impact_lag = 1;
  // Two polygons touch when their skins do. The overlap of the skins that is left alone is the slop, so that they come
  // to rest between skin - slop and skin apart, circles between 0 and the slop in each other.
  stated.skin = 2 * b2_polygonRadius;
  stated.slop = b2_linearSlop;
  stated.joint_slop = b2_linearSlop;  // the error below which a joint's position counts as solved
  stated.creep = 0;                   // friction bounds the sum of the impulses, and can hold a body completely
  stated.iterations = whole_number(settings, "velocity");
  stated.position_iterations = whole_number(settings, "position");
  stated.restitution_threshold = std::stod(settings.at("restitution"));
  stated.epsilon = std::ldexp(1.0, -24);
  stated.whole_impulses = settings.at("sleep") == "off";  // sleeping contacts report none
  stated.spring_limit = 2;                                // symplectic Euler
  return stated;
}

std::string version() {
  return std::to_string(b2_version.major) + "." + std::to_string(b2_version.minor) + "." +
         std::to_string(b2_version.revision);
}

// b2_polygonRadius is 0.01 m, b2_linearSlop 0.005 m.
const std::vector<std::string> caveats{
    "float arithmetic throughout, angles included",
    ("polygons, boxes and edges carry a skin of 0.01 m, circles none: two boxes come to rest 0.015 m apart, a circle "
     "on "
     "a box 0.005 m"),
    "nothing bounces below a closing speed of 1 m/s (option restitution)",
    "8 velocity and 3 position iterations leave errors in tall stacks and at large mass ratios",
    "damping c divides velocities by 1 + c h each step; the scene means e^(-c h)",
    "nothing moves by more than 2 m or turns by more than a quarter turn in a step",
    "a body that continuous collision stops loses the rest of its step, so a bounce off the ground may cost time",
    "vertices closer than 0.0025 m are welded; polygons have at most eight",
    "a soft distance joint is an implicit spring: it damps more than its coefficient says",
    "sleeping is off by default: a sleeping stack would have perfect energy"};

const Catalog<Engine>::Entry entry{{
    .name = "box2d",
    .about = "Box2D 2.4: sequential impulses, symplectic Euler, float",
    .source = "Box2D, Erin Catto, box2d.org; says it is " + version() + ", as 2.4.1 does too",
    .caveats = caveats,
    .options =
        {
            {.key = "velocity",
             .value = "8",
             .about = "iterations of the velocity solver",
             .min = 1,
             .max = 10000,
             .whole = true},
            {.key = "position",
             .value = "3",
             .about = "iterations of the position solver",
             .min = 0,
             .max = 10000,
             .whole = true},
            restitution_threshold_option(),
            continuous_option(),
            sleep_option(),
            warm_start_option(),
        },
    .ladders = {{.option = "velocity", .values = {"4", "8", "16"}}},
    .stepping = stepping,
    .unsupported = unsupported,
    .build = [](const Scene& scene, const Settings& settings) -> std::unique_ptr<Simulation> {
      return on_paths(scene, std::make_unique<Box2d>(scene, complete(self(), settings)));
    },
    .in_process = true,
}};

}  // namespace
}  // namespace plumb
