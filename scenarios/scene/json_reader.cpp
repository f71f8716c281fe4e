#include "scenarios/scene/json_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>

#include "scenarios/scene/json_parse.h"
#include "scenarios/scene/nearest.h"

namespace plumb {
namespace {

using Json = nlohmann::json;

std::string quoted(const std::string& text) { return '"' + printable(text) + '"'; }

std::string description(const Json& value) {
  switch (value.type()) {
    case Json::value_t::object:
      return "an object";
    case Json::value_t::array:
      return "a list of " + std::to_string(value.size());
    case Json::value_t::string:
      return quoted(value.get_ref<const std::string&>());
    default:
      return value.dump();
  }
}

std::string shortest(double number) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr};
}

std::string description(Range range) {
  return "a number from " + shortest(range.least) + " to " + shortest(range.most) +
         (range.unit.empty() ? "" : " " + std::string(range.unit));
}

}  // namespace

void JsonReader::refuse(const std::string& why) const {
  throw std::invalid_argument(printable(file_, file_.npos) + ": " + (path_.empty() ? "top level" : path_) + ": " + why);
}

void JsonReader::expected(const std::string& what) const {
  refuse("expected " + what + ", found " + description(value_));
}

void JsonReader::unknown_word(const std::vector<std::string>& names, const char* what) const {
  const std::string* given = value_.get_ptr<const std::string*>();
  if (given != nullptr) refuse(unknown(what, printable(*given), names));
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  expected("one of: " + list);
}

void JsonReader::object(const std::vector<const char*>& required, const std::vector<const char*>& optional) const {
  if (!value_.is_object()) expected("an object");
  std::vector<std::string> names(required.begin(), required.end());
  names.insert(names.end(), optional.begin(), optional.end());
  for (const auto& item : value_.items()) {
    if (std::find(names.begin(), names.end(), item.key()) == names.end()) {
      refuse(unknown("key", printable(item.key()), names));
    }
  }
  for (const char* key : required) must_have(key);
}

void JsonReader::must_have(const char* key) const {
  if (!value_.is_object()) expected("an object");
  if (!has(key)) refuse("the key \"" + std::string(key) + "\" is missing");
}

JsonReader JsonReader::operator[](const char* key) const {
  return {value_.at(key), file_, path_ + (path_.empty() ? "" : ".") + key};
}

std::size_t JsonReader::list() const {
  if (!value_.is_array()) expected("a list");
  return value_.size();
}

JsonReader JsonReader::operator[](std::size_t index) const {
  return {value_.at(index), file_, path_ + "[" + std::to_string(index) + "]"};
}

double JsonReader::number(Range range) const {
  if (!value_.is_number()) expected(description(range));
  const double number = value_.get<double>();
  if (!(number >= range.least && number <= range.most)) expected(description(range));
  return number;
}

bool JsonReader::boolean() const {
  if (!value_.is_boolean()) expected("true or false");
  return value_.get<bool>();
}

Vec JsonReader::vector(Range range) const {
  if (!value_.is_array() || value_.size() != 2) expected("a list of two numbers, [x, y]");
  return {(*this)[std::size_t{0}].number(range), (*this)[std::size_t{1}].number(range)};
}

std::string JsonReader::text(std::size_t least, std::size_t most) const {
  const std::string* text = value_.get_ptr<const std::string*>();
  if (text == nullptr || text->size() < least || text->size() > most) {
    expected("a text of " + std::to_string(least) + " to " + std::to_string(most) + " bytes");
  }
  if (printable(*text, text->size()) != *text) refuse("expected one line of text, without control characters");
  return *text;
}

}  // namespace plumb
