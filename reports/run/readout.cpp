#include "reports/run/readout.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace plumb {
namespace {

// A NaN that no arithmetic produces: a value that still has it was not written.
constexpr std::uint64_t blank_bits = 0x7ff8'706c'756d'6221;
const double blank = std::bit_cast<double>(blank_bits);
const BodyState unwritten{{blank, blank}, blank, {blank, blank}, blank};

bool is_blank(double value) { return std::bit_cast<std::uint64_t>(value) == blank_bits; }

bool any_blank(const BodyState& state) {
  return is_blank(state.position.x) || is_blank(state.position.y) || is_blank(state.angle) ||
         is_blank(state.velocity.x) || is_blank(state.velocity.y) || is_blank(state.angular_velocity);
}

bool finite(Vec v) { return std::isfinite(v.x) && std::isfinite(v.y); }

std::string error_in(const ContactState& contact, std::size_t bodies) {
  if (contact.a >= bodies || contact.b >= bodies || contact.a == contact.b) {
    return fmt::format("is between bodies {} and {} of a scene of {}, counted from 0", contact.a, contact.b, bodies);
  }
  const bool all_finite = finite(contact.point) && finite(contact.normal) && std::isfinite(contact.normal_impulse) &&
                          std::isfinite(contact.tangent_impulse) && std::isfinite(contact.separation);
  return all_finite ? "" : "has numbers that are not finite";
}

}  // namespace

std::span<const BodyState> Readout::states(const Simulation& simulation) {
  const std::size_t bodies = scene_.bodies.size();
  constexpr std::size_t guard = 16;  // states past the end, where a write does no harm and is noticed
  states_.assign(bodies + guard, unwritten);
  const std::span<BodyState> result = std::span(states_).first(bodies);
  simulation.read(result);
  for (std::size_t i = 0; i < bodies; ++i) {
    if (!any_blank(result[i])) continue;
    throw std::runtime_error(fmt::format("read() left out body \"{}\": it must write the whole state of all {} bodies",
                                         scene_.bodies[i].name, bodies));
  }
  for (const BodyState& state : std::span(states_).subspan(bodies)) {
    if (any_blank(state)) continue;
    throw std::runtime_error(
        fmt::format("read() wrote past the end: the scene has {} bodies, in the order of Scene::bodies", bodies));
  }
  return result;
}

std::span<const ContactState> Readout::contacts(const Simulation& simulation) {
  contacts_.clear();
  simulation.read_contacts(contacts_);
  for (const ContactState& contact : contacts_) {
    const std::string error = error_in(contact, scene_.bodies.size());
    if (!error.empty()) throw std::runtime_error("read_contacts(): a contact " + error);
  }
  return contacts_;
}

}  // namespace plumb
