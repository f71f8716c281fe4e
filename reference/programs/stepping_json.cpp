#include "reference/programs/protocol.h"

#include <limits>
#include <nlohmann/json.hpp>
#include <variant>
#include <vector>

#include "scenarios/scene/json_reader.h"

namespace plumb::protocol {
namespace {

constexpr NumberRange any_size{0, std::numeric_limits<double>::max()};
constexpr NumberRange any_count{0, 1e6};
constexpr NumberRange in_substeps{0, 1e3};

/// What may be left out; then it is as Stepping says.
struct Field {
  const char* key;
  std::variant<double Stepping::*, int Stepping::*, bool Stepping::*> member;
  NumberRange range = any_size;
};

const Field fields[] = {{"drift", &Stepping::drift, {-1, 1}},
                        {"dampingInterval", &Stepping::damping_interval},
                        {"order", &Stepping::order, any_count},
                        {"orderInContact", &Stepping::order_in_contact, any_count},
                        {"impactLag", &Stepping::impact_lag, in_substeps},
                        {"impactLead", &Stepping::impact_lead, in_substeps},
                        {"skin", &Stepping::skin},
                        {"slop", &Stepping::slop},
                        {"jointSlop", &Stepping::joint_slop},
                        {"angularSlop", &Stepping::angular_slop},
                        {"contactFrequency", &Stepping::contact_frequency},
                        {"fixedContactFrequency", &Stepping::fixed_contact_frequency},
                        {"jointFrequency", &Stepping::joint_frequency},
                        {"heldAnchors", &Stepping::held_anchors},
                        {"tangentRotation", &Stepping::tangent_rotation},
                        {"creep", &Stepping::creep},
                        {"restSpeed", &Stepping::rest_speed},
                        {"restitutionThreshold", &Stepping::restitution_threshold},
                        {"iterations", &Stepping::iterations, any_count},
                        {"positionIterations", &Stepping::position_iterations, any_count},
                        {"differencedVelocities", &Stepping::differenced_velocities},
                        {"wholeImpulses", &Stepping::whole_impulses},
                        {"looksAhead", &Stepping::looks_ahead}};

constexpr Word<double> arithmetics[] = {{"float", 0x1p-24}, {"double", 0x1p-53}};

double value_of(const JsonReader& in, NumberRange range, double /*as*/) { return in.number(range); }
int value_of(const JsonReader& in, NumberRange range, int /*as*/) { return static_cast<int>(in.number(range)); }
bool value_of(const JsonReader& in, NumberRange /*of numbers*/, bool /*as*/) { return in.boolean(); }

}  // namespace

nlohmann::ordered_json stepping_as_json(const Stepping& stated) {
  nlohmann::ordered_json json{{"arithmetic", stated.epsilon > 1e-12 ? "float" : "double"}, {"substep", stated.h}};
  for (const Field& field : fields) {
    std::visit([&](auto member) { json[field.key] = stated.*member; }, field.member);
  }
  if (stated.spring_limit) json["springLimit"] = *stated.spring_limit;
  return json;
}

Stepping stepping_of(const JsonReader& in, double dt) {
  std::vector<const char*> optional{"substep", "springLimit"};
  for (const Field& field : fields) optional.push_back(field.key);
  in.object({"arithmetic"}, optional);
  Stepping stated{.dt = dt, .h = in.number("substep", dt, {dt * 1e-6, dt}), .whole_impulses = false};
  for (const Field& field : fields) {
    if (!in.has(field.key)) continue;
    std::visit([&](auto member) { stated.*member = value_of(in[field.key], field.range, stated.*member); },
               field.member);
  }
  if (stated.damping_interval > dt) in["dampingInterval"].number({0, dt});
  stated.epsilon = in["arithmetic"].one_of<double>(arithmetics);
  if (in.has("springLimit")) stated.spring_limit = in["springLimit"].number(any_size);
  return stated;
}

}  // namespace plumb::protocol
