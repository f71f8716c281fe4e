#include "reports/writers/in_words.h"

#include <fmt/format.h>

namespace plumb {

std::string in_words(const TruthCheck& check) {
  const std::string of = check.body.empty() ? "" : " of " + check.body;
  const std::string what = fmt::format("{}{} at {:.4g} s: ", check.quantity, of, check.time);
  if (!check.reported) return what + "not reported";
  const std::string side = check.relation == Relation::equal ? "" : name_of(check.relation) + std::string(" ");
  const std::string phases = !check.spread ? ""
                                           : fmt::format(" (worst of {} phases; off by {:.2g} ... {:.2g})",
                                                         check.spread->phases, check.spread->min, check.spread->max);
  return what + fmt::format("{:.6g}, expected {}{:.6g} +- {:.2g} {}{}", check.measured, side, check.expected,
                            check.tolerance, check.unit, phases);
}

std::string in_words(const InvariantCheck& check) {
  const std::string where = check.where.empty() ? "" : " of " + check.where;
  return fmt::format("breaks {}{} at {:.4g} s: {:.3g}, tolerance {:.2g} {} ({:.3g} times{}){}{}", check.name, where,
                     check.time, check.value, check.tolerance, check.unit, check.ratio,
                     check.phases > 1 ? fmt::format(", worst of {} phases", check.phases) : "",
                     check.detail.empty() ? "" : ": ", check.detail);
}

}  // namespace plumb
