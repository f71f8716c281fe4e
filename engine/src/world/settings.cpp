#include "impulse/settings.h"

#include <stdexcept>
#include <utility>

#include "bodies/integrator.h"
#include "broad_phase/broad_phase.h"
#include "core/method_list.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr Real longest_step = 10;            // s; longer steps resolve nothing, and speed times step may overflow
constexpr Real strongest_gravity = 1000000;  // m/s^2; more is a mistake in units
constexpr int most_iterations = 10000;       // with more, a step may take minutes and look like a hang
constexpr int most_workers = 256;
constexpr int most_substeps = 1000;

[[noreturn]] void refuse_settings(const std::string& what) { throw std::invalid_argument("Settings: " + what); }

template <class Method>
void check_name(const char* field, const std::string& name) {
  if (MethodList<Method>::knows(name)) return;
  std::string names;
  for (const MethodInfo& method : MethodList<Method>::infos()) {
    names += (names.empty() ? "" : ", ") + method.name;
  }
  refuse_settings(std::string(field) + " \"" + name + "\" is not known; there are: " + names);
}

}  // namespace

void validate(const Settings& settings) {
  if (!(settings.dt > 0 && settings.dt <= longest_step)) {
    refuse_settings("dt must be above 0 and at most " + std::to_string(longest_step) + " s, got " +
                    std::to_string(settings.dt));
  }
  if (!is_finite(settings.gravity) || length(settings.gravity) > strongest_gravity) {
    refuse_settings("gravity must be finite and at most " + std::to_string(strongest_gravity) + " m/s^2");
  }
  if (settings.iterations < 1 || settings.iterations > most_iterations) {
    refuse_settings("iterations must be from 1 to " + std::to_string(most_iterations) + ", got " +
                    std::to_string(settings.iterations));
  }
  if (settings.position_iterations < 0 || settings.position_iterations > most_iterations) {
    refuse_settings("position_iterations must be from 0 to " + std::to_string(most_iterations) + ", got " +
                    std::to_string(settings.position_iterations));
  }
  if (settings.substeps < 1 || settings.substeps > most_substeps) {
    refuse_settings("substeps must be from 1 to " + std::to_string(most_substeps) + ", got " +
                    std::to_string(settings.substeps));
  }
  if (settings.workers < 1 || settings.workers > most_workers) {
    refuse_settings("workers must be from 1 to " + std::to_string(most_workers) + ", got " +
                    std::to_string(settings.workers));
  }
  for (const auto& [field, value] :
       {std::pair("sleep_linear_speed", settings.sleep_linear_speed),
        std::pair("sleep_angular_speed", settings.sleep_angular_speed), std::pair("sleep_time", settings.sleep_time)}) {
    if (!is_finite(value) || !(value > 0)) {
      refuse_settings(std::string(field) + " must be finite and above 0, got " + std::to_string(value));
    }
  }
  check_name<Solver>("solver", settings.solver);
  check_name<Integrator>("integrator", settings.integrator);
  check_name<BroadPhase>("broad_phase", settings.broad_phase);
}

const char* name_of(SolverType solver) { return solver == SolverType::accurate ? "accurate" : "soft-step"; }

std::vector<MethodInfo> solvers() { return MethodList<Solver>::infos(); }
std::vector<MethodInfo> integrators() { return MethodList<Integrator>::infos(); }
std::vector<MethodInfo> broad_phases() { return MethodList<BroadPhase>::infos(); }

StatedErrors stated_errors(const Settings& settings) {
  validate(settings);
  StatedErrors errors;
  errors.h = settings.dt;
  const auto integrator = MethodList<Integrator>::make(settings.integrator);
  errors.drift = integrator->drift();
  errors.order = integrator->order();
  errors.order_in_contact = integrator->order_in_contact();
  const auto solver = MethodList<Solver>::make(settings.solver);
  solver->state(settings, errors);
  errors.looks_ahead = solver->margin(settings).time > 0;
  return errors;
}

}  // namespace impulse::inline IMPULSE_PRECISION
