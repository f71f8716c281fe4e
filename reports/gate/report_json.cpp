#include "reports/gate/report_json.h"

#include "reports/gate/words.h"

namespace plumb {
namespace {

constexpr int report_format = 1;  // see writers/json.cpp

TruthCheck check_from(const JsonReader& from) {
  for (const char* key : {"body", "quantity", "unit", "time", "error", "tolerance", "passed", "reported"})
    from.must_have(key);
  return {.body = any_text(from["body"]),
          .quantity = any_text(from["quantity"]),
          .unit = any_text(from["unit"]),
          .time = number_or_null(from["time"]),
          .error = number_or_null(from["error"]),
          .tolerance = number_or_null(from["tolerance"]),
          .passed = from["passed"].boolean(),
          .reported = from["reported"].boolean()};
}

InvariantCheck invariant_from(const JsonReader& from) {
  for (const char* key : {"name", "unit", "status", "value", "tolerance"}) from.must_have(key);
  return {.name = any_text(from["name"]),
          .unit = any_text(from["unit"]),
          .status = check_status_from(from["status"]),
          .value = number_or_null(from["value"]),
          .tolerance = number_or_null(from["tolerance"])};
}

RunRecord run_from(const JsonReader& from) {
  for (const char* key :
       {"scenario", "variant", "engine", "method", "exact", "dt", "verdict", "metrics", "truth", "invariants"})
    from.must_have(key);
  RunRecord run{.scenario = any_text(from["scenario"]),
                .variant = any_text(from["variant"]),
                .engine = any_text(from["engine"]),
                .method = any_text(from["method"]),
                .exact = from["exact"].boolean(),
                .dt = from["dt"].number({0, 1, "s"}),
                .verdict = verdict_from(from["verdict"])};
  for_each_member(from["metrics"], [&](const std::string& name, const JsonReader& metric) {
    metric.object({"value", "unit"});
    run.metrics[name] = {number_or_null(metric["value"]), any_text(metric["unit"])};
  });
  const JsonReader truth = from["truth"];
  for (std::size_t i = 0; i < truth.list(); ++i) run.truth.push_back(check_from(truth[i]));
  const JsonReader invariants = from["invariants"];
  for (std::size_t i = 0; i < invariants.list(); ++i) run.invariants.push_back(invariant_from(invariants[i]));
  return run;
}

}  // namespace

Report report_from(const JsonReader& from) {
  for (const char* key : {"plumb", "environment", "engines", "runs"}) from.must_have(key);
  from["plumb"].number({report_format, report_format});
  Report report{.environment = texts_from(from["environment"])};
  const JsonReader engines = from["engines"];
  for (std::size_t i = 0; i < engines.list(); ++i) {
    const JsonReader engine = engines[i];
    for (const char* key : {"name", "source", "exact"}) engine.must_have(key);
    report.engines.push_back(
        {.name = any_text(engine["name"]), .source = any_text(engine["source"]), .exact = engine["exact"].boolean()});
  }
  const JsonReader runs = from["runs"];
  for (std::size_t i = 0; i < runs.list(); ++i) report.runs.push_back(run_from(runs[i]));
  return report;
}

}  // namespace plumb
