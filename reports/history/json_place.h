#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace plumb {

/// A value in a JSON document and where it stands. Everything throws std::invalid_argument, naming the place, for what
/// is not as expected. The document must outlive it.
class JsonPlace {
 public:
  using Json = nlohmann::ordered_json;

  /// `name`: of the document.
  JsonPlace(const Json& json, std::string name) : JsonPlace(json, std::move(name), "") {}

  JsonPlace at(const std::string& key) const;
  bool has(const std::string& key) const { return json_.is_object() && json_.contains(key); }
  std::vector<JsonPlace> items() const;                            // of a list
  std::vector<std::pair<std::string, JsonPlace>> members() const;  // of an object

  std::string text() const;
  double number() const;          // finite
  double number_or_null() const;  // null is NaN
  int count() const;              // a whole number from 0 up to what fits

  const Json& json() const { return json_; }
  [[noreturn]] void refuse(const std::string& expected) const;

 private:
  JsonPlace(const Json& json, std::string name, std::string path)
      : json_(json), name_(std::move(name)), path_(std::move(path)) {}

  const Json& json_;
  std::string name_, path_;
};

/// The document in a text. Throws std::invalid_argument, naming it, for what is not JSON.
nlohmann::ordered_json parse_json(const std::string& text, const std::string& name);

}  // namespace plumb
