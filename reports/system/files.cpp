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

NewFile::NewFile(NewFile&& other) noexcept
    : place_(std::move(other.place_)), path_(std::move(other.path_)), ours_(std::exchange(other.ours_, false)) {}

NewFile::~NewFile() {
  std::error_code ignored;
  if (ours_) std::filesystem::remove(path_, ignored);
}

bool NewFile::write(const std::string& text) {
  std::ofstream out(path_, std::ios::binary | std::ios::trunc);
  ours_ = out.is_open();
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  return out.good();
}

std::filesystem::path NewFile::put_in_place() {
  std::filesystem::rename(path_, place_);
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
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) {
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
