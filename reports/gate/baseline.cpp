#include "reports/gate/baseline.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>

#include "reports/run/horizon.h"

namespace plumb {
namespace {

// FNV-1a, 64 bits, over the bytes of words, lowest first whatever the machine's order.
class Hash {
 public:
  void add(std::uint64_t word) {
    for (int shift = 0; shift < 64; shift += 8) value_ = (value_ ^ (word >> shift & 0xff)) * 1099511628211U;
  }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  void add(Vec of) {
    add(of.x);
    add(of.y);
  }
  std::string text() const { return fmt::format("{:016x}", value_); }

 private:
  std::uint64_t value_ = 14695981039346656037U;
};

// A name that is the same whenever an event happens to be noticed.
std::string name_of_check(const TruthCheck& check) {
  const bool of_an_event = check.quantity == name_of(Quantity::apex) || check.quantity == name_of(Quantity::landing);
  return fmt::format("truth: {}{}{}", check.quantity, check.body.empty() ? "" : " of " + check.body,
                     of_an_event ? "" : fmt::format(" at {:.6g} s", check.time));
}

// The second of a name is "... (2)".
void put(std::map<std::string, KeptNumber>& numbers, const std::string& name, KeptNumber number) {
  std::string unique = name;
  for (int i = 2; numbers.count(unique) != 0; ++i) unique = fmt::format("{} ({})", name, i);
  numbers.emplace(std::move(unique), std::move(number));
}

CheckStatus standing_of(const TruthCheck& check) {
  if (!check.reported) return CheckStatus::not_reported;
  return check.passed ? CheckStatus::held : CheckStatus::broken;
}

}  // namespace

std::string RunKey::text() const {
  return fmt::format("{}{}, {}", scenario, variant.empty() ? "" : " " + variant, label_of(engine, method));
}

RunKey key_of(const RunRecord& run) { return {run.scenario, run.variant, run.engine, run.method}; }

std::map<std::string, std::string> platform_of(const std::map<std::string, std::string>& environment) {
  std::map<std::string, std::string> platform;
  for (const char* name : {"architecture", "compiler", "flags", "libm"}) {
    const auto found = environment.find(name);
    if (found != environment.end()) platform.insert(*found);
  }
  return platform;
}

std::string hash_of(const Trace& trace) {
  Hash hash;
  for (std::size_t moment = 0; moment < trace.size(); ++moment) {
    hash.add(trace.time(moment));
    for (const BodyState& state : trace.states(moment)) {
      hash.add(state.position);
      hash.add(state.angle);
      hash.add(state.velocity);
      hash.add(state.angular_velocity);
    }
    for (const ContactState& contact : trace.contacts(moment)) {
      hash.add(static_cast<std::uint64_t>(contact.a));
      hash.add(static_cast<std::uint64_t>(contact.b));
      hash.add(contact.point);
      hash.add(contact.normal);
      hash.add(contact.normal_impulse);
      hash.add(contact.tangent_impulse);
      hash.add(contact.separation);
    }
  }
  return hash.text();
}

KeptRun kept(const RunRecord& run) {
  KeptRun all{.exact = run.exact,
              .verdict = run.verdict,
              .reason = run.status == Status::ok ? "" : run.reason,
              .bits = run.trace ? hash_of(*run.trace) : ""};
  for (const auto& [name, measured] : run.metrics) {
    // Of an ensemble, which a report may have and a gate does not.
    if (name != horizon_note().name) put(all.numbers, name, {measured.unit, measured.value});
  }
  for (const TruthCheck& check : run.truth) {
    put(all.numbers, name_of_check(check), {check.unit, check.error, standing_of(check), check.tolerance});
  }
  for (const InvariantCheck& check : run.invariants) {
    put(all.numbers, "invariant: " + check.name, {check.unit, check.value, check.status, check.tolerance});
  }
  return all;
}

Baseline baseline_of(const Report& report) {
  Baseline baseline{.platform = platform_of(report.environment)};
  for (const EngineNote& engine : report.engines) {
    if (!engine.exact) baseline.engines[engine.name] = engine.source;
  }
  for (const RunRecord& run : report.runs) {
    baseline.dt = run.dt;
    baseline.runs.emplace(key_of(run), kept(run));
  }
  return baseline;
}

}  // namespace plumb
