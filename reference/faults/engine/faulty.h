#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bodies/integrator.h"
#include "broad_phase/broad_phase.h"
#include "core/method_list.h"
#include "reference/faults/engine/fault.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

inline const char* kind_of(const Solver*) { return "solver"; }
inline const char* kind_of(const Integrator*) { return "integrator"; }
inline const char* kind_of(const BroadPhase*) { return "broad-phase"; }

/// How a faulty method joins, from its own file:
///
///     const Faulty<Solver> entry{{.name = "friction-sign", .about = "...", .mutates = "article"}, [] { return ...;
///     }};
template <class Method>
struct Faulty {
  using Maker = typename MethodList<Method>::Maker;

  Faulty(Fault fault, Maker make) {
    fault.kind = kind_of(static_cast<const Method*>(nullptr));
    if (makers().empty()) MethodList<Method>::extend(make_faulty);
    makers().emplace_back(fault.name, std::move(make));
    note(std::move(fault));
  }

 private:
  static std::unique_ptr<Method> make_faulty(std::string_view name) {
    for (const auto& [known, make] : makers()) {
      if (known == name) return make();
    }
    return nullptr;
  }
  static std::vector<std::pair<std::string, Maker>>& makers() {
    static std::vector<std::pair<std::string, Maker>> all;
    return all;
  }
};

}  // namespace impulse::inline IMPULSE_PRECISION
