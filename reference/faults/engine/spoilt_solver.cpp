#include "reference/faults/engine/spoilt_solver.h"

#include <algorithm>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

bool same_pair(const Contact& a, const Contact& b) {
  return a.body_a == b.body_a && a.body_b == b.body_b && a.part_a == b.part_a && a.part_b == b.part_b;
}

// What a solver leaves in a contact for the next step and for the outside; of points that it was not shown, nothing.
void store(const std::vector<Contact>& from, std::vector<Contact>& contacts) {
  for (Contact& contact : contacts) {
    const auto solved =
        std::find_if(from.begin(), from.end(), [&](const Contact& one) { return same_pair(one, contact); });
    if (solved != from.end()) contact.offset = solved->offset;
    for (std::size_t p = 0; p < static_cast<std::size_t>(contact.count); ++p) {
      const bool shown = solved != from.end() && p < static_cast<std::size_t>(solved->count);
      const ContactPoint left = shown ? solved->points[p] : ContactPoint{};
      contact.points[p].normal_impulse = left.normal_impulse;
      contact.points[p].tangent_impulse = left.tangent_impulse;
      contact.points[p].total_normal_impulse = left.total_normal_impulse;
      contact.points[p].total_tangent_impulse = left.total_tangent_impulse;
    }
  }
}

}  // namespace

void SpoiltSolver::step(StepData& data) {
  SpoiltStep spoilt{data.bodies, data.contacts, data.forces, data.settings};
  before(spoilt);
  StepData shown{spoilt.bodies,   spoilt.contacts, data.joints, spoilt.forces,
                 data.integrator, spoilt.settings, data.workers};
  right_->step(shown);
  store(spoilt.contacts, data.contacts);
  after(spoilt);
}

}  // namespace impulse::inline IMPULSE_PRECISION
