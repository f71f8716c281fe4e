#pragma once

#include <CLI/App.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "reports/study/study.h"
#include "reports/system/jobs.h"

namespace plumb {

/// How a study is carried out: options that all of them have, and that no result hangs on.
struct StudyOptions {
  std::string out = "out";
  int jobs = default_jobs();
  bool resume = false;
  bool fresh = false;
  std::string shard;
  double seconds = 60;
  double mebibytes = 4096;

  void attach_to(CLI::App&);
};

/// Finds out the points that are not known yet and writes what they come to; a shard's points only. Returns the exit
/// code. Throws std::invalid_argument for what the user should put right, before anything is run.
int conduct(const Study&, const nlohmann::ordered_json& configuration, const StudyOptions&);

}  // namespace plumb
