#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace plumb {

/// A file in the making, beside its place; it goes away again unless it is put there.
class NewFile {
 public:
  explicit NewFile(const std::filesystem::path& place) : place_(place), path_(place.string() + ".part") {}
  NewFile(NewFile&&) noexcept;
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  NewFile& operator=(NewFile&&) = delete;
  ~NewFile();

  /// Whether all of the text could be written.
  bool write(const std::string& text);

  /// Takes its place, whatever was there. Throws std::filesystem::filesystem_error.
  std::filesystem::path put_in_place();

 private:
  std::filesystem::path place_, path_;
  bool ours_ = false;
};

/// What a file holds. Throws std::invalid_argument, with the system's reason, when it cannot be read or holds more than
/// `most` bytes.
std::string read_text(const std::string& path, std::size_t most);

}  // namespace plumb
