#include "reports/pushed.h"

#include <cmath>

namespace plumb {

Pushed pushed_in(std::span<const ContactState> contacts) {
  Pushed pushed;
  for (const ContactState& contact : contacts) pushed[{contact.a, contact.b}] += contact.normal_impulse;
  return pushed;
}

double changed(const Pushed& before, const Pushed& now, const ContactState& contact) {
  const auto of = [&](const Pushed& pushed) {
    const auto found = pushed.find({contact.a, contact.b});
    return found == pushed.end() ? 0 : found->second;
  };
  return std::abs(of(now) - of(before));
}

}  // namespace plumb
