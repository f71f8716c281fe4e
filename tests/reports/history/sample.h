#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>

#include "reports/history/snapshot.h"

namespace plumb {

/// Snapshot i of several, one a day: a metric that is 1 before snapshot 10 and 2 from then on, one that is not finite,
/// the worst error ratio and step times.
inline Snapshot sample_snapshot(int i) {
  const bool late = i >= 10;
  Snapshot snapshot{.commit = "c0ffee" + std::to_string(i),
                    .at = fmt::format("2026-{:02}-{:02}T00:00:00Z", 1 + i / 28, 1 + i % 28),
                    .command = {"plumb", "report"},
                    .environment = {{"compiler", "GNU 12.2.0"}, {"processor", "one"}}};
  SnapshotRun& ours = snapshot.runs[{"bounce", "e=0.5", "impulse", 1.0 / 60}];
  ours.verdict = late ? "wrong" : "right";
  ours.metrics["energy_rise"] = {late ? 2.0 : 1.0, "J"};
  ours.metrics["horizon"] = {std::numeric_limits<double>::quiet_NaN(), "s"};
  ours.metrics[worst_ratio_metric] = {0.5, "1"};
  ours.time = {0.7 + i % 3 * 0.01, 0.69, 0.75, 15};
  snapshot.runs[{"bounce", "e=0.5", "box2d", 1.0 / 60}] = {.verdict = "failed"};
  return snapshot;
}

/// A temporary folder for each process, removed after the test.
class InFolder : public ::testing::Test {
 protected:
  InFolder() { std::filesystem::create_directories(folder_); }
  ~InFolder() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void put(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  std::string bytes(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) / ("plumb-history-" + std::to_string(getpid()));
};

}  // namespace plumb
