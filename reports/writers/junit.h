#pragma once

#include <span>
#include <string>

namespace plumb {

/// One test case of JUnit XML: an engine in a scene.
struct TestCase {
  std::string scene, engine;
  std::string failure;       // "" if it passes
  std::string skipped = {};  // why it did not run; "" if it did
};

/// In the dialect that CI systems read, described at https://github.com/testmoapp/junitxml.
std::string junit(const std::string& name, std::span<const TestCase>);

}  // namespace plumb
