#pragma once

#include "reports/gate/result.h"

/// A result with what writers must cope with.
namespace plumb {

inline GateResult sample_gate_result() {
  const RunKey fine{"bounce", "e=0.5", "impulse", ""};
  const RunKey odd{"<img src=x onerror=alert(1)>", "a|b & \"c\" 'd' `e`\x01\n", "box2d", "x=1"};
  return {.verdict = "NOT as accepted: 1 of 2 runs differ (1 worse, 1 changed)",
          .runs = {fine, odd},
          .regressions = {{.run = odd,
                           .metric = "verdict",
                           .before = "right",
                           .now = "wrong",
                           .why = "]]> <b>diverged</b>",
                           .rule = Rule::verdict,
                           .change = Change::worse},
                          {.run = odd,
                           .metric = "energy_drift",
                           .before = "0.1 J",
                           .now = "0.2 J",
                           .tolerance = "1e-09 off",
                           .why = "1e+08 times farther off than rounding explains",
                           .rule = Rule::bound}},
          .notes = {"Another platform (libm: this, was <that>)."}};
}

inline GateResult passed_gate_result() {
  return {.verdict = "as accepted: 1 run, to the bit", .runs = {{"bounce", "e=0.5", "impulse", ""}}};
}

}  // namespace plumb
