#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "reports/run/run.h"
#include "reports/timing/report.h"

namespace plumb {

/// What a command line asks about times.
struct TimingOptions {
  std::string against;  // a program; "": times are not asked for
  std::string engine = "impulse";
  std::string file;  // for timing_json; "": none

  void attach_to(CLI::App&);
};

/// Times the cases in that program and in this one, and judges. Throws std::invalid_argument, naming the option, for a
/// program that cannot be run, does not step on request, or does so on another machine; and for a file that cannot be
/// written. Before anything is run.
TimingReport time_against(const TimingOptions&, const std::vector<Case>&, double dt);

}  // namespace plumb
