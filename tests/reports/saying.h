#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "reports/cli/program.h"

namespace plumb {

struct Said {
  int code;
  std::string out, err;
};

/// Runs the program with a command line and captures its exit code and output.
inline Said say(std::vector<std::string> arguments) {
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  const int code = program(std::move(arguments));
  std::fflush(stdout);
  std::fflush(stderr);
  return {code, ::testing::internal::GetCapturedStdout(), ::testing::internal::GetCapturedStderr()};
}

}  // namespace plumb
