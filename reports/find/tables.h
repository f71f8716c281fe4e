#pragma once

#include <span>
#include <string>
#include <vector>

/// The forms in which a search, or a corpus that ran again, tells other tools.
namespace plumb {

/// A scene and an engine for JUnit.
struct TestCase {
  std::string scene, engine;
  std::string failure;  // "" if it passes
};

/// In the dialect that CI systems read, described at https://github.com/testmoapp/junitxml.
std::string junit(const std::string& name, std::span<const TestCase>);

/// A table for the console; the first row is its head: columns as wide as they need be, numbers not aligned.
std::string plain_table(std::span<const std::vector<std::string>> rows);

}  // namespace plumb
