#include <algorithm>
#include <cmath>

#include "reports/judge/invariant.h"
#include "reports/judge/roundings.h"
#include "scenarios/catalog.h"

// A sum of impulses that each push is off by what its terms lose: a share of the largest that acts in that step.
namespace plumb::invariants::push {
namespace {

std::optional<InvariantCheck> check(const InvariantContext& context) {
  if (!reports_contacts(context.trace)) return not_reported();
  Worst worst;
  for (std::size_t moment = 0; moment < context.trace.size(); ++moment) {
    double largest = 0;
    for (const ContactState& contact : context.trace.contacts(moment)) {
      largest = std::max(largest, std::abs(contact.normal_impulse));
    }
    for (const ContactState& contact : context.trace.contacts(moment)) {
      worst.see(-contact.normal_impulse, roundings_of_solver(context.stepping) * largest, context.trace.time(moment),
                [&] { return pair_name(context.scene, contact.a, contact.b); });
    }
  }
  return worst.result();
}

const Catalog<Invariant>::Entry entry{
    {.name = "push", .unit = "N s", .definition = "contacts push: no normal impulse is negative", .check = check}};

}  // namespace
}  // namespace plumb::invariants::push
