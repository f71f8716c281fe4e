#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "reports/judge/coefficients.h"
#include "reports/judge/invariant.h"
#include "reports/judge/pushed.h"
#include "reports/judge/roundings.h"
#include "scenarios/catalog.h"

// |t| <= mu n holds for every impulse and so for their sums over a step. A method of first order, or one that
// sweeps over the contacts, may hold friction to the push that it knew (see pushed.cpp).
namespace plumb::invariants::cone {
namespace {

std::optional<InvariantCheck> check(const InvariantContext& context) {
  if (!reports_contacts(context.trace)) return not_reported();
  if (!context.stepping.whole_impulses) return not_reported();
  const Coefficients coefficients(context.scene);
  Worst worst;
  for (std::size_t moment = 0; moment < context.trace.size(); ++moment) {
    double largest = 0;
    for (const ContactState& contact : context.trace.contacts(moment)) {
      largest = std::max({largest, std::abs(contact.normal_impulse), std::abs(contact.tangent_impulse)});
    }
    const auto before = moment > 0 ? context.trace.contacts(moment - 1) : std::span<const ContactState>{};
    const auto contacts = context.trace.contacts(moment);
    const std::vector<double> late = known_late(before, contacts, context.stepping);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const ContactState& contact = contacts[i];
      const double mu = coefficients.sticking(contact.a, contact.b);
      const double most = mu * std::max(0.0, contact.normal_impulse);
      worst.see(std::abs(contact.tangent_impulse) - most,
                mu * late[i] + roundings_of_solver(context.stepping) * largest, context.trace.time(moment),
                [&] { return pair_name(context.scene, contact.a, contact.b); });
    }
  }
  return worst.result();
}

const Catalog<Invariant>::Entry entry{
    {.name = "cone",
     .unit = "N s",
     .definition = "friction stays in its cone: no tangential impulse exceeds the normal one times the coefficient",
     .check = check}};

}  // namespace
}  // namespace plumb::invariants::cone
