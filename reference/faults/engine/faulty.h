#pragma once

#include <utility>

#include "bodies/integrator.h"
#include "broad_phase/broad_phase.h"
#include "core/method_list.h"
#include "reference/faults/engine/fault.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Remembers a fault for faults().
void note(Fault fault);

inline const char* kind_of(const Solver*) { return "solver"; }
inline const char* kind_of(const Integrator*) { return "integrator"; }
inline const char* kind_of(const BroadPhase*) { return "broad-phase"; }

/// How a faulty method joins, from its own file:
///
///     const Faulty<Solver> entry{{.name = "friction-sign", .about = "...", .spoils = "article"}, [] { return ...; }};
template <class Method>
struct Faulty {
  Faulty(Fault fault, typename MethodList<Method>::Maker make) {
    fault.kind = kind_of(static_cast<const Method*>(nullptr));
    const typename MethodList<Method>::Entry entry(MethodInfo{fault.name, fault.about, fault.source}, std::move(make),
                                                   Offer::unlisted);
    note(std::move(fault));
  }
};

}  // namespace impulse::inline IMPULSE_PRECISION
