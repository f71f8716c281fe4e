#include <algorithm>
#include <cmath>

#include "reports/invariant.h"
#include "reports/roundings.h"
#include "scenarios/catalog.h"

// A sum of impulses that each push is off by what its terms lose: a share of the largest that acts in that step.
namespace plumb {
namespace {

std::optional<InvariantCheck> check(const Ground& ground) {
  if (!reveals_contacts(ground.trace)) return not_revealed();
  Worst worst;
  for (std::size_t moment = 0; moment < ground.trace.size(); ++moment) {
    double largest = 0;
    for (const ContactState& contact : ground.trace.contacts(moment)) {
      largest = std::max(largest, std::abs(contact.normal_impulse));
    }
    for (const ContactState& contact : ground.trace.contacts(moment)) {
      worst.see(-contact.normal_impulse, roundings_of_solver(ground.stepping) * largest, ground.trace.time(moment),
                [&] { return pair_name(ground.scene, contact.a, contact.b); });
    }
  }
  return worst.result();
}

const Catalog<Invariant>::Entry entry{
    {.name = "push", .unit = "N s", .definition = "contacts push: no normal impulse is negative", .check = check}};

}  // namespace
}  // namespace plumb
