#pragma once

#include <optional>
#include <string>

namespace plumb {

/// Counts the instructions that this process and threads begun from now on execute outside the kernel, where system
/// and processor allow it.
class InstructionCounter {
 public:
  InstructionCounter();
  InstructionCounter(const InstructionCounter&) = delete;
  InstructionCounter& operator=(const InstructionCounter&) = delete;
  ~InstructionCounter();

  /// So far; nothing where they are not counted.
  std::optional<double> count() const;
  /// Why they are not counted; "" where they are.
  const std::string& missing() const { return missing_; }

 private:
  int file_ = -1;
  std::string missing_;
};

}  // namespace plumb
