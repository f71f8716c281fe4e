#include "reference/faults/engine/mutated_solver.h"

#include <algorithm>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

bool same_pair(const Contact& a, const Contact& b) {
  return a.body_a == b.body_a && a.body_b == b.body_b && a.part_a == b.part_a && a.part_b == b.part_b;
}

// Copies what the solver leaves in contacts for the next step and for readers: impulses, whether they slip, and where
// their bodies turned within the step, normals and points. Points that it was not shown get no impulses.
void store(const std::vector<Contact>& from, std::vector<Contact>& contacts) {
  for (Contact& contact : contacts) {
    const auto solved =
        std::find_if(from.begin(), from.end(), [&](const Contact& one) { return same_pair(one, contact); });
    const bool shown = solved != from.end();
    if (shown) {
      contact.offset = solved->offset;
      contact.slips = solved->slips;
    }
    if (shown && (solved->found_a.p != contact.found_a.p || solved->found_b.p != contact.found_b.p)) {
      contact.count = solved->count;
      contact.normal = solved->normal;
      contact.found_a = solved->found_a;
      contact.found_b = solved->found_b;
      contact.found_separation = solved->found_separation;
      contact.points = solved->points;
      continue;
    }
    for (std::size_t p = 0; p < static_cast<std::size_t>(contact.count); ++p) {
      const ContactPoint left =
          shown && p < static_cast<std::size_t>(solved->count) ? solved->points[p] : ContactPoint{};
      contact.points[p].normal_impulse = left.normal_impulse;
      contact.points[p].tangent_impulse = left.tangent_impulse;
      contact.points[p].total_normal_impulse = left.total_normal_impulse;
      contact.points[p].total_tangent_impulse = left.total_tangent_impulse;
    }
  }
}

}  // namespace

void MutatedSolver::step(StepData& data) {
  MutatedStep mutated{data.bodies, data.contacts, data.forces, data.settings};
  before(mutated);
  StepData shown{mutated.bodies,  mutated.contacts, data.joints, mutated.forces,
                 data.integrator, mutated.settings, data.workers};
  right_->step(shown);
  store(mutated.contacts, data.contacts);
  after(mutated);
}

}  // namespace impulse::inline IMPULSE_PRECISION
