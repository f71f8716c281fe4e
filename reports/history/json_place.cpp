#include "reports/history/json_place.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace plumb {

JsonPlace JsonPlace::at(const std::string& key) const {
  if (!json_.is_object()) refuse("an object");
  const std::string path = path_.empty() ? key : path_ + "." + key;
  const auto found = json_.find(key);
  if (found == json_.end()) throw std::invalid_argument(fmt::format("{}: {} is missing", name_, path));
  return {*found, name_, path};
}

std::vector<JsonPlace> JsonPlace::items() const {
  if (!json_.is_array()) refuse("a list");
  std::vector<JsonPlace> all;
  for (std::size_t i = 0; i < json_.size(); ++i) {
    all.push_back(JsonPlace(json_[i], name_, fmt::format("{}[{}]", path_, i)));
  }
  return all;
}

std::vector<std::pair<std::string, JsonPlace>> JsonPlace::members() const {
  if (!json_.is_object()) refuse("an object");
  std::vector<std::pair<std::string, JsonPlace>> all;
  for (const auto& [key, value] : json_.items()) all.emplace_back(key, at(key));
  return all;
}

std::string JsonPlace::text() const {
  if (!json_.is_string()) refuse("a text");
  return json_.get<std::string>();
}

double JsonPlace::number() const {
  if (!json_.is_number()) refuse("a number");
  return json_.get<double>();
}

double JsonPlace::number_or_null() const {
  return json_.is_null() ? std::numeric_limits<double>::quiet_NaN() : number();
}

int JsonPlace::count() const {
  if (!json_.is_number_unsigned() || json_.get<std::uint64_t>() > std::numeric_limits<int>::max()) {
    refuse("a whole number from 0");
  }
  return json_.get<int>();
}

void JsonPlace::refuse(const std::string& expected) const {
  std::string found = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (found.size() > 60) found = found.substr(0, 57) + "...";
  throw std::invalid_argument(
      fmt::format("{}: {}expected {}, found {}", name_, path_.empty() ? "" : path_ + ": ", expected, found));
}

nlohmann::ordered_json parse_json(const std::string& text, const std::string& name) {
  try {
    return nlohmann::ordered_json::parse(text);
  } catch (const nlohmann::ordered_json::exception& error) {
    throw std::invalid_argument(fmt::format("{}: is not JSON: {}", name, error.what()));
  }
}

}  // namespace plumb
