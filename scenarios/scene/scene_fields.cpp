#include "scenarios/scene/scene_fields.h"

#include <vector>

#include "scenarios/scene/json_reader.h"

namespace plumb {

void BodyNames::add(const JsonReader& in, const std::string& name) {
  if (!indices_.emplace(name, indices_.size()).second) in.refuse("the name \"" + printable(name) + "\" is given twice");
}

std::size_t BodyNames::find(const JsonReader& in) const {
  const auto found = indices_.find(in.text(1, limits::name));
  if (found != indices_.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [name, index] : indices_) names.push_back(printable(name));
  in.unknown_word(names, "body");
}

std::size_t BodyNames::find_dynamic(const JsonReader& in) const {
  const std::size_t body = find(in);
  if (!is_dynamic(body)) in.expected("a dynamic body");
  return body;
}

std::pair<std::size_t, std::size_t> BodyNames::find_two(const JsonReader& in) const {
  if (in.list() != 2) in.expected("a list of two bodies");
  const std::size_t a = find(in[std::size_t{0}]);
  const std::size_t b = find(in[std::size_t{1}]);
  if (a == b) in.refuse("expected two different bodies, found one body twice");
  if (!is_dynamic(a) && !is_dynamic(b)) in.refuse("expected at least one dynamic body");
  return {a, b};
}

void refuse_as_foreign(const JsonReader& in, std::initializer_list<const char*> keys, const char* word) {
  for (const char* key : keys) {
    if (in.has(key)) in[key].refuse(foreign_word(word));
  }
}

std::pair<Vec, Vec> read_anchors(const JsonReader& in) {
  if (in.list() != 2) in.expected("a list of two points");
  return {in[std::size_t{0}].vector(limits::coordinate), in[std::size_t{1}].vector(limits::coordinate)};
}

void write_unless(OrderedJson& into, const char* key, double value, double otherwise) {
  if (!same_bits(value, otherwise)) into[key] = value;
}

void write_unless(OrderedJson& into, const char* key, Vec value, Vec otherwise) {
  if (!same_bits(value.x, otherwise.x) || !same_bits(value.y, otherwise.y)) into[key] = as_json(value);
}

}  // namespace plumb
