#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "../saying.h"

namespace plumb {

/// A temporary folder of this process, removed after the test, and small studies that run in it.
class StudyFiles : public ::testing::Test {
 public:
  ~StudyFiles() override { std::filesystem::remove_all(folder_); }

 protected:
  StudyFiles() { std::filesystem::create_directories(folder_); }

  std::string at(const std::string& name) const { return (folder_ / name).string(); }

  static std::string text(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  static void put(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

  /// The command line of a study of 28 jobs in 4 groups.
  std::vector<std::string> words(const std::string& out, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{"study",    "speed", "--scenarios", "spring:w=4", "--engine", "impulse:solver=xpbd",
                                 "--engine", "box2d", "--dt",        "1/30",       "1/60",     "1/120",
                                 "1/240",    "--out", at(out)};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  /// A study's document without its timings.
  nlohmann::ordered_json document(const std::string& out, const std::string& study = "speed") const {
    auto json = nlohmann::ordered_json::parse(text(at(out) + "/study-" + study + ".json"));
    json.erase("timings");
    return json;
  }

  std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) / ("plumb-study-" + std::to_string(getpid()));
};

}  // namespace plumb
