#include "reports/engines/step_cost.h"

#include <algorithm>
#include <limits>

#include "reference/programs/protocol.h"
#include "reports/system/clock.h"

namespace plumb {
namespace {

constexpr double patience = 1;  // s without a faster round
constexpr double longest = 5;   // s
constexpr double faster = 0.98;

}  // namespace

StepCost cost_of_step(LineProcess& process, const ProgramLimits& limits, std::size_t bodies, double dt) {
  constexpr double unknown = std::numeric_limits<double>::max();
  StepCost least{unknown, unknown};
  double compared = unknown;
  protocol::StepsAhead ahead;
  std::size_t number = 0;
  const Stopwatch all;
  for (Stopwatch since; since.seconds() < patience && all.seconds() < longest;) {
    const std::size_t count = ahead.count();
    const double before = cpu_seconds(CpuClock::thread);
    const Stopwatch round;
    double own = 0;
    process.send(protocol::ask_steps(count, dt), limits);
    for (std::size_t i = 0; i < count; ++i) {
      own += protocol::read_step(process.receive(limits), bodies, ++number).seconds;
    }
    const double passed = round.seconds();
    const double steps = static_cast<double>(count);
    least.beyond = std::min(least.beyond, (passed - own) / steps);
    least.plumbs = std::min(least.plumbs, (cpu_seconds(CpuClock::thread) - before) / steps);
    ahead.took(count, passed);
    if (least.beyond > faster * compared) continue;
    compared = least.beyond;
    since = Stopwatch();
  }
  return least;
}

}  // namespace plumb
