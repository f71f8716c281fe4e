#pragma once

#include <filesystem>

namespace plumb {

/// A program copied to a place of its own, gone in the end. How a file came to lie in memory page by page, by a linker
/// or by a copy, makes some 5 % of a step, the same program or not; copies made alike have only chance between them.
/// Those of a run that was killed go with the next one's beginning.
class ProgramCopy {
 public:
  /// Throws std::invalid_argument, naming the program, where it cannot be copied to the folder for temporary files.
  explicit ProgramCopy(const std::filesystem::path& program);
  ProgramCopy(const ProgramCopy&) = delete;
  ProgramCopy& operator=(const ProgramCopy&) = delete;
  ~ProgramCopy();

  const std::filesystem::path& path() const { return path_; }

 private:
  void remove() const;

  std::filesystem::path folder_, path_;
  int lock_ = -1;  // on the folder, as long as this lives
};

}  // namespace plumb
