#include "solver/pile_island.h"

#include <algorithm>

#include "contacts/contact_rows.h"
#include "core/stages.h"
#include "solver/turning.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Contacts, from which laying them out in lanes pays.
constexpr std::size_t least_pile = 64;

void scale_offsets(const StepData& data, const Island& island, Real by) {
  if (by == 1) return;
  for (const Tie& tie : island.contacts) data.contacts[tie.contact].offset *= by;
}

}  // namespace

bool is_pile(const StepData& data, const Island& island) {
  if (island.contacts.size() < least_pile || !island.joints.empty()) return false;
  const bool is_few = few(island);
  return std::none_of(island.contacts.begin(), island.contacts.end(), [&](const Tie& tie) {
    const Contact& contact = data.contacts[tie.contact];
    return contact.restitution > 0 ||
           (is_few && !contact.discs() && stir_of(contact, data.bodies).moves(data.settings.dt));
  });
}

void plan_pile(const StepData& data, Island& island, const std::vector<Velocity>& acceleration) {
  Bearing bearing;
  if (may_need_substeps(island.bodies.size(), data.settings)) {
    for (const Tie& tie : island.contacts) bearing.add(make_row(data.bodies, data.contacts, tie.contact));
  }
  island.cut(data.settings, substeps_for(island.bodies, bearing, data.bodies, acceleration, data.settings));
  end_stage("pile: bearing");
  island.settling = settles(data, island);
  if (island.settling) island.sweeps = settling_sweeps_for(island.bodies.size());
  relax_blows(data, island);
  end_stage("pile: struck");
}

void relax_blows(const StepData& data, Island& island) {
  const auto struck = [&](const Tie& tie) {
    return new_or_deep(data.contacts[tie.contact]) &&
           at_speed(make_row(data.bodies, data.contacts, tie.contact), data.bodies);
  };
  const int more_sweeps = closed(data.bodies, island.bodies) ? more_sweeps_for(island.bodies.size()) : 0;
  if (more_sweeps > 0 && std::any_of(island.contacts.begin(), island.contacts.end(), struck)) {
    island.more_sweeps = more_sweeps;
  }
}

void step_as_pile(StepData& data, const Partition& parts, const Island& island,
                  const std::vector<Velocity>& acceleration, std::vector<Motion>& motion, Pile& pile,
                  Pile::RowOf& row_of) {
  scale_offsets(data, island, island.offset_scale);
  pile.step(data, parts, island, acceleration, motion, row_of);
  scale_offsets(data, island, 1 / island.offset_scale);
}

}  // namespace impulse::inline IMPULSE_PRECISION
