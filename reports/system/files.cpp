#include "reports/system/files.h"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "scenarios/scene/json_reader.h"

namespace plumb {

namespace {

namespace fs = std::filesystem;

// Where the links of a place lead, whether or not there is a file.
fs::path target_of(const fs::path& place) {
  constexpr int most_links = 40;  // as many as Linux follows
  fs::path target = place;
  std::error_code ignored;
  for (int links = 0; fs::is_symlink(target, ignored); ++links) {
    if (links == most_links) throw FileError(place.string() + ": cannot be written: a circle of symbolic links");
    target = target.parent_path() / fs::read_symlink(target, ignored);
  }
  return target;
}

bool is_device(const fs::path& place) {
  std::error_code ignored;
  const fs::file_status status = fs::status(place, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

}  // namespace

NewFile::NewFile(const fs::path& place) : place_(place), direct_(is_device(place)) {
  target_ = direct_ ? place : target_of(place);
  path_ = direct_ ? place : fs::path(target_.string() + ".part");
}

NewFile::NewFile(NewFile&& other) noexcept
    : place_(std::move(other.place_)),
      target_(std::move(other.target_)),
      path_(std::move(other.path_)),
      ours_(std::exchange(other.ours_, false)),
      direct_(other.direct_) {}

NewFile::~NewFile() {
  std::error_code ignored;
  if (ours_) fs::remove(path_, ignored);
}

bool NewFile::write(const std::string& text) {
  if (direct_ && text.empty()) return true;  // a pipe would end for its reader
  errno = 0;
  std::ofstream out(path_, std::ios::binary | std::ios::trunc);
  ours_ = out.is_open() && !direct_;
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  return out.good();
}

void NewFile::write_all(const std::string& text) {
  if (write(text)) return;
  const int why = errno;
  throw FileError(fmt::format("{}: cannot be written{}{}", place_.string(), why == 0 ? "" : ": ",
                              why == 0 ? "" : std::strerror(why)));
}

fs::path NewFile::put_in_place() {
  if (!direct_) fs::rename(path_, target_);
  ours_ = false;
  return place_;
}

std::string read_text(const std::string& path, std::size_t most) {
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  std::string text(most + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  // A folder can be opened but not read.
  if (!in.eof() && in.gcount() == 0) {
    throw std::invalid_argument(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
  }
  if (in.gcount() > static_cast<std::streamsize>(most)) {
    throw std::invalid_argument(fmt::format("{}: is larger than {} MiB", path, most >> 20));
  }
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

std::string csv_field(const std::string& text) {
  const bool formula = !text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos;
  const std::string safe = formula ? "'" + text : text;
  if (safe.find_first_of(",\"\r\n") == std::string::npos) return safe;
  std::string quoted = "\"";
  for (const char letter : safe) {
    quoted += letter;
    if (letter == '"') quoted += '"';
  }
  return quoted + '"';
}

std::string csv_field(double number) { return std::isfinite(number) ? fmt::format("{}", number) : ""; }

std::string markdown_cell(const std::string& text) {
  constexpr std::string_view special = "&<>|`*_[]@#~\\!";
  std::string out;
  for (const char letter : printable(text, text.npos)) {
    if (special.find(letter) == special.npos) {
      out += letter;
    } else {
      out += fmt::format("&#{};", static_cast<int>(letter));
    }
  }
  return out;
}

std::string markdown_table(std::span<const std::vector<std::string>> rows, Cells cells) {
  std::string text;
  for (const auto& row : rows) {
    const bool head = text.empty();
    text += "|";
    for (const std::string& cell : row) text += " " + markdown_cell(cell) + " |";
    text += "\n";
    if (!head) continue;
    text += "|---|";
    for (std::size_t column = 1; column < row.size(); ++column) text += cells == Cells::numbers ? "---:|" : "---|";
    text += "\n";
  }
  return text;
}

std::string xml_escaped(const std::string& text) {
  std::string out;
  for (const char letter : printable(text, text.npos)) {
    switch (letter) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&apos;";
        break;
      default:
        out += letter;
    }
  }
  return out;
}

}  // namespace plumb
