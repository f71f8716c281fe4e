#include "impulse/looks_ahead.h"

#include "core/method_list.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

bool looks_ahead(const Settings& settings) {
  validate(settings);
  return MethodList<Solver>::make(settings.solver)->margin(settings).time > 0;
}

}  // namespace impulse::inline IMPULSE_PRECISION
