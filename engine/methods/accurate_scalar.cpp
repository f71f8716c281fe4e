#include "core/method_list.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

const MethodList<Solver>::Entry accurate_scalar_entry{
    {"accurate-scalar", "the same one contact at a time in piles, too: what the lanes of `accurate` are tested against",
     accurate_source},
    [] { return make_accurate(false); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
