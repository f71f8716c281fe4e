#pragma once

#include <cmath>
#include <limits>
#include <memory>

#include "reports/report.h"

namespace plumb {

/// A report with one of everything that writers must cope with.
inline Report sample_report() {
  const auto scene = std::make_shared<const Scene>(
      Scene{.gravity = {0, 0}, .bodies = {{.name = "box", .shapes = {{.geometry = Box{.size = {1, 2}}}}}}});
  const auto trace = std::make_shared<Trace>(1);
  for (int i = 0; i <= 1000; ++i) {
    const BodyState state{.position = {i / 3.0, 0}, .velocity = {1, 0}};
    trace->record(i / 60.0, std::span(&state, 1), {});
  }
  const RunRecord exact{.scenario = "slide",
                        .variant = "on ice",
                        .parameters = {{"speed", 1}},
                        .engine = "sliding",
                        .exact = true,
                        .dt = 1.0 / 60,
                        .metrics = {{"energy_rise", {0, "1"}}},
                        .verdict = Verdict::right,
                        .scene = scene,
                        .trace = trace};
  RunRecord wrong = exact;
  wrong.engine = "an engine with a rather long name";
  wrong.method = "solver=one,integrator=another,iterations=1000";
  wrong.exact = false;
  wrong.verdict = Verdict::wrong;
  wrong.truth = {{.body = "box, \"the\" first",
                  .quantity = "x",
                  .unit = "m",
                  .time = 2,
                  .expected = 1.0 / 3,
                  .measured = std::numeric_limits<double>::quiet_NaN(),
                  .error = std::numeric_limits<double>::quiet_NaN(),
                  .tolerance = 0.1,
                  .source = "</script><script>alert(1)</script>"}};
  wrong.invariants = {{.name = "energy", .unit = "J", .value = 1},
                      {.name = "push",
                       .unit = "N s",
                       .status = CheckStatus::broken,
                       .value = 0.5,
                       .tolerance = 0,
                       .ratio = std::numeric_limits<double>::infinity(),
                       .time = 1.5,
                       .where = "box, \"the\" first - ground"},
                      {.name = "cone", .unit = "N s", .status = CheckStatus::not_reported}};
  RunRecord failed = exact;
  failed.engine = "lost";
  failed.exact = false;
  failed.status = Status::failed;
  failed.verdict = Verdict::failed;
  failed.reason =
      "diverged at t = 1 s: body \"box\" " + std::string(300, 'x') + " and a good deal more to be said of it";
  failed.metrics.clear();
  failed.trace = nullptr;
  return {.title = "Plumb: run",
          .command = {"plumb", "run"},
          .environment = {{"compiler", "some"}},
          .scenarios = {{.name = "slide", .question = "Does it slide?", .parameters = {{.name = "speed"}}}},
          .engines = {{.name = "lost"}},
          .metrics = {{"energy_rise", "1", "largest rise", "lower"}},
          .invariants = {{"push", "N s", "contacts push"}},
          .runs = {exact, wrong, failed},
          .comparisons = {{.scenario = "slide",
                           .variant = "on ice",
                           .a = "an engine with a rather long name:solver=one,integrator=another,iterations=1000",
                           .b = "lost",
                           .key = KeyDifferences{.energy = {0.25, 0.125},
                                                 .momentum = {2, 0},
                                                 .energy_scale = 4,
                                                 .rest_b = 3,
                                                 .overlap_a = 0.015,
                                                 .diverged_at = 0.5},
                           .metrics = {{"position_difference_max", {1.0 / 3, "m"}}},
                           .verdict = Verdict::failed,
                           .reason = "lost: diverged"}},
          .timings = {{.scenario = "slide", .variant = "on ice", .engine = "lost", .step_us = 1.5, .repetitions = 5}},
          .clock = {{"outside_step", 0.25}}};
}

}  // namespace plumb
