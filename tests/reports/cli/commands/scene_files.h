#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "../../saying.h"

namespace plumb {

/// A folder of this process's own for scene files and reports, gone after the test.
class SceneFiles : public ::testing::Test {
 public:
  ~SceneFiles() override { std::filesystem::remove_all(folder_); }

 protected:
  SceneFiles() { std::filesystem::create_directories(folder_); }

  std::string at(const char* name) const { return folder_ / name; }
  std::string put(const char* name, const std::string& text) const {
    std::ofstream(at(name)) << text;
    return at(name);
  }
  nlohmann::ordered_json json(const std::string& path) const {
    return nlohmann::ordered_json::parse(std::ifstream(path));
  }

  std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) / ("plumb-scene-files-" + std::to_string(getpid()));
};

}  // namespace plumb
