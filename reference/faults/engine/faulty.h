#pragma once

#include <functional>
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
///
/// A mistake of any size is a method for each size, "NAME=SIZE", and not in faults():
///
///     const Faulty<Solver> entry{"scaled-inertia", [](double factor) { return ...; }};
template <class Method>
struct Faulty {
  using Maker = typename MethodList<Method>::Maker;
  using SizedMaker = std::function<std::unique_ptr<Method>(double size)>;

  Faulty(Fault fault, Maker make) {
    fault.kind = kind_of(static_cast<const Method*>(nullptr));
    join(fault.name, [make = std::move(make)](std::string_view) { return make(); });
    note(std::move(fault));
  }

  Faulty(const std::string& name, SizedMaker make) {
    join(name + "=", [make = std::move(make)](std::string_view size) { return make(std::stod(std::string(size))); });
  }

 private:
  using MakerOfRest = std::function<std::unique_ptr<Method>(std::string_view rest)>;  // what follows the known name

  static void join(const std::string& name, MakerOfRest make) {
    if (makers().empty()) MethodList<Method>::extend(make_faulty);
    makers().emplace_back(name, std::move(make));
  }
  static std::unique_ptr<Method> make_faulty(std::string_view name) {
    for (const auto& [known, make] : makers()) {
      const bool sized = known.back() == '=';
      if (sized ? name.starts_with(known) : name == known) return make(name.substr(known.size()));
    }
    return nullptr;
  }
  static std::vector<std::pair<std::string, MakerOfRest>>& makers() {
    static std::vector<std::pair<std::string, MakerOfRest>> all;
    return all;
  }
};

}  // namespace impulse::inline IMPULSE_PRECISION
