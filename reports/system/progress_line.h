#pragma once

#include <string>

namespace plumb {

/// One line on standard error that is written over and over, on a terminal only, and gone in the end.
class ProgressLine {
 public:
  ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  void show(const std::string& what) const;

 private:
  void clear() const;
  bool terminal_;
};

}  // namespace plumb
