#pragma once

#include <string>
#include <vector>

#include "figures.h"
#include "race.h"

namespace plumb::benchmarks {

/// One scene's race, ready to be written.
struct Contest {
  struct Row {
    std::string engine;
    Finish finish;
    Figures figures;
  };
  std::string scene;
  std::string about;
  Window window;
  int threads = 1;
  int rounds = 0;
  Basis basis = Basis::cpu;
  std::string against;  // whom speeds are told against
  std::vector<Row> rows;
};

/// For people: a line for each engine.
std::string table(const Contest&);

/// In the shape of Google Benchmark's JSON, which its tools compare: every round, and the median over rounds as an
/// aggregate; times in us a step. A engine without a result has `error_occurred` and `error_message`.
std::string google_json(const std::vector<Contest>&);

}  // namespace plumb::benchmarks
