#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace plumb {

/// A file cannot be written, as on a full disk: neither a mistake of the program nor of what it was asked.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file being written under a temporary name beside its destination; deleted unless it is put in place. A symbolic
/// link stays one: its target is replaced. A device or a pipe is written to at once.
class NewFile {
 public:
  /// Throws FileError if the place is a circle of symbolic links.
  explicit NewFile(const std::filesystem::path& place);
  NewFile(NewFile&&) noexcept;
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  NewFile& operator=(NewFile&&) = delete;
  ~NewFile();

  /// Returns whether the whole text was written.
  bool write(const std::string& text);

  /// The same; throws FileError, with the system's reason, if it was not.
  void write_all(const std::string& text);

  /// Renames the file to its destination, replacing whatever is there. Returns the place as it was given. Throws
  /// std::filesystem::filesystem_error.
  std::filesystem::path put_in_place();

 private:
  std::filesystem::path place_, target_, path_;  // as given; where links lead; temporary
  bool ours_ = false;
  bool direct_ = false;  // a device or a pipe
};

/// Reads a whole file. Throws std::invalid_argument, with the system's reason, if it cannot be read or is larger than
/// `most` bytes.
std::string read_text(const std::string& path, std::size_t most);

/// A field of a CSV file, quoted as RFC 4180 says: quotes around a comma, a quote or a line break; quotes doubled. An
/// apostrophe goes before what a spreadsheet would take for a formula.
std::string csv_field(const std::string& text);

/// The shortest text that reads back to the same bits; empty if the number is not finite.
std::string csv_field(double number);

/// One line of text for a table in Markdown: characters that mean something there or in HTML become character
/// references, which both show as text.
std::string markdown_cell(const std::string& text);

/// A table in Markdown; the first row is its head. Columns after the first are aligned to the right if they hold
/// numbers.
enum class Cells { words, numbers };
std::string markdown_table(std::span<const std::vector<std::string>> rows, Cells = Cells::words);

/// Text as the content of an element or attribute of XML 1.0, which allows no control characters, escaped or not.
std::string xml_escaped(const std::string& text);

}  // namespace plumb
