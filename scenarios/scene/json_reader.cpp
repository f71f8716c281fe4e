#include "scenarios/scene/json_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "scenarios/scene/nearest.h"

namespace plumb {
namespace {

struct Feature {
  std::vector<std::string_view> words;  // small letters only
  const char* why;
};

constexpr const char* changing_force =
    "forces that change with time are not in the format; a spring to a kinematic body with a \"path\" pulls in its "
    "rhythm, and a body may have a \"velocity\" at the start";

// Features of Box2D, Chipmunk, Rapier and matter.js, by the words of their formats.
const std::vector<Feature>& features() {
  static const std::vector<Feature> all{
      {{"motor", "enablemotor", "motorspeed", "maxmotortorque", "maxmotorforce", "simplemotor", "motorjoint"},
       "write \"motor\": { \"speed\": .., \"strength\": .. } in a revolute joint, in rad/s and N m, or in a prismatic "
       "one, in m/s and N"},
      {{"lowerangle", "upperangle", "enablelimit", "rotarylimit", "rotarylimitjoint"},
       "write \"limits\": [lower, upper] in a revolute joint, in rad"},
      {{"lowertranslation", "uppertranslation", "groovejoint"},
       "write \"limits\": [lower, upper] in a prismatic joint, in m"},
      {{"minlength", "maxlength", "slidejoint", "rope", "ropejoint"},
       "limits of distance joints (ropes) are not in the format: one keeps its \"length\", or yields with a "
       "\"stiffness\""},
      {{"wheel", "wheeljoint"}, "wheel joints are not in the format; a revolute joint and a spring come close"},
      {{"mouse", "mousejoint", "target"},
       "mouse joints are not in the format; a spring to a point of the world pulls like one"},
      {{"pulley", "gear", "ratchet", "frictionjoint", "filterjoint", "gearjoint", "pulleyjoint"},
       "joints of this kind are not in the format"},
      {{"enablespring", "hertz", "frequencyhz", "dampingratio", "springhertz", "linearhertz", "angularhertz"},
       "springs have a \"stiffness\" in N/m and a \"damping\" in N s/m: k = m (2 pi f)^2, c = 4 pi m f zeta"},
      {{"localanchora", "localanchorb", "anchora", "anchorb", "pointa", "pointb", "referenceangle"},
       "anchors are points of the world at the start: \"anchor\", or \"anchors\" of a distance joint"},
      {{"collideconnected"}, "bodies that a joint connects never collide with each other; the format has no exception"},
      {{"chain", "chainshape", "edge", "edgeshape", "loop", "isloop"},
       "chains are not in the format; write a segment for each edge"},
      {{"sensor", "issensor", "sensors"}, "sensors are not in the format: nothing is asked of them"},
      {{"categorybits", "maskbits", "category", "mask", "filter", "collisionfilter", "collisiongroups"},
       "write \"layers\" in a body: two bodies collide if their layers share a bit. Separate categories and masks are "
       "not in the format"},
      {{"groupindex", "group"}, "collision groups are not in the format; write \"layers\" in a body"},
      {{"rollingresistance", "rollingfriction", "torsionalfriction", "frictionair", "frictionstatic"},
       "rolling resistance and other frictions are not in the format; \"friction\" is Coulomb's, and bodies have "
       "\"linearDamping\" and \"angularDamping\""},
      {{"tangentspeed", "tangentialspeed", "surfacevelocity", "surfacespeed", "beltspeed"},
       "surface speeds are not in the format; a kinematic body that moves is a belt"},
      {{"restitutionthreshold", "velocitythreshold"},
       "restitution thresholds are not in the format: restitution acts at any speed, and engines state their own"},
      {{"path", "keyframes", "waypoints", "trajectory"},
       "write \"path\": { \"type\": \"sinusoidal\", \"amplitude\": [x, y], \"frequency\": .. } in a kinematic body; "
       "other paths are not in the format"},
      {{"impulse", "linearimpulse", "angularimpulse", "schedule", "starttime", "endtime", "until", "pulse", "periodic",
        "sinusoidal"},
       changing_force},
      {{"linearvelocity"}, "write \"velocity\""},
      {{"isbullet", "ccd", "ccdenabled"}, "write \"bullet\""},
      {{"mass", "inertia", "centerofmass", "rotationalinertia"},
       "mass and inertia follow from the shapes and their \"density\", kg/m^2"},
      {{"expectations", "expect", "checks", "truths", "tests", "assertions"},
       "write \"truth\": [{ \"body\": .., \"quantity\": .., \"time\": .., \"value\": .., \"source\": .. }] for what is "
       "known of the result"},
      {{"awake", "allowsleep", "enablesleep", "sleepthreshold", "issleeping", "isawake"},
       "sleeping is a matter of the engine, not of the scene: see plumb help impulse"}};
  return all;
}

}  // namespace

std::string foreign_word(std::string_view word) {
  std::string plain;
  for (const char letter : word) {
    if (letter == '-' || letter == '_') continue;
    plain += letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  }
  for (const Feature& feature : features()) {
    if (std::ranges::find(feature.words, plain) != feature.words.end()) return feature.why;
  }
  return "";
}

namespace {

using Json = nlohmann::json;

constexpr std::size_t max_depth = 16;  // a scene needs 6

// A key as it stands in the path to a value: bare if that is clear, else as in the text.
std::string in_path(const std::string& key) {
  const auto is_clear = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !key.empty() && std::ranges::all_of(key, is_clear) ? printable(key) : Json(printable(key)).dump();
}

// Builds the value as the parser reads it and keeps track of the path to the current position.
class JsonBuilder final : public nlohmann::json_sax<Json> {
 public:
  explicit JsonBuilder(std::string_view file) : file_(file) {}

  Json take() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }  // cannot occur in a text
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& key) override {
    open_.back().key = std::move(key);
    if (open_.back().value->contains(open_.back().key)) refuse("this key is given twice");
    return true;
  }

  bool parse_error(std::size_t, const std::string& token, const nlohmann::detail::exception& error) override {
    if (dynamic_cast<const Json::out_of_range*>(&error) != nullptr) {
      refuse("expected a number that double precision holds, found " + printable(token));
    }
    const std::string_view said = error.what();
    const auto place = said.find("line ");
    constexpr std::size_t longest = 200;
    throw std::invalid_argument(file_ + ": " +
                                printable(place == std::string_view::npos ? said : said.substr(place), longest));
  }

 private:
  struct Open {
    Json* value = nullptr;  // stays valid: its parent does not grow until this is closed
    std::string key;        // of the member being read
  };

  Json* put(Json value) {
    if (open_.empty()) return &(root_ = std::move(value));
    const Open& in = open_.back();
    if (in.value->is_object()) return &((*in.value)[in.key] = std::move(value));
    in.value->push_back(std::move(value));
    return &in.value->back();
  }

  bool add(Json value) {
    put(std::move(value));
    return true;
  }

  bool open(Json value) {
    if (open_.size() == max_depth) refuse("is nested deeper than any scene");
    open_.push_back({put(std::move(value)), ""});
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  [[noreturn]] void refuse(const std::string& why) const {
    std::string path;
    for (const Open& in : open_) {
      if (in.value->is_object()) {
        path += (path.empty() ? "" : ".") + in_path(in.key);
      } else {
        // The element being read is already in the list, unless this is the innermost level.
        path += "[" + std::to_string(in.value->size() - (&in == &open_.back() ? 0 : 1)) + "]";
      }
    }
    throw std::invalid_argument(file_ + ": " + (path.empty() ? "top level" : path) + ": " + why);
  }

  std::string file_;
  Json root_;
  std::vector<Open> open_;
};

// The length in bytes of the printable UTF-8 character that `text` begins with; 0 if it does not begin with one.
std::size_t printable_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0u) == 0x80u; };
  const unsigned first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7F ? 1 : 0;
  if (first < 0xC2 || first > 0xF4) return 0;
  if (first == 0xC2 && byte(1) < 0xA0) return 0;  // more control characters
  const std::size_t length = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  for (std::size_t i = 1; i < length; ++i) {
    if (!follows(i)) return 0;
  }
  return length;
}

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

// A word of another engine's format gets the reason why there is no such word here.
std::string unknown_or_foreign(std::string_view what, const std::string& word, const std::vector<std::string>& names) {
  const std::string why = foreign_word(word);
  return why.empty() ? unknown(what, printable(word), names) : quoted(word) + ": " + why;
}

std::string shortest(double number) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr};
}

std::string description(NumberRange range) {
  return "a number from " + shortest(range.least) + " to " + shortest(range.most) +
         (range.unit.empty() ? "" : " " + std::string(range.unit));
}

}  // namespace

std::string printable(std::string_view text, std::size_t most) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = printable_length(text);
    if (out.size() + std::max<std::size_t>(length, 1) > most) return out + "...";
    out += length == 0 ? "?" : text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

Json parse_json(std::string_view text, std::string_view file) {
  JsonBuilder builder(printable(file, text.npos));
  Json::sax_parse(text, &builder);
  return builder.take();
}

void JsonReader::refuse(const std::string& why) const {
  throw std::invalid_argument(printable(file_, file_.npos) + ": " + (path_.empty() ? "top level" : path_) + ": " + why);
}

void JsonReader::expected(const std::string& what) const {
  refuse("expected " + what + ", found " + description(value_));
}

void JsonReader::unknown_word(const std::vector<std::string>& names, const char* what) const {
  const std::string* given = string_or_null();
  if (given != nullptr) refuse(unknown_or_foreign(what, *given, names));
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
      refuse(unknown_or_foreign("key", item.key(), names));
    }
  }
  for (const char* key : required) must_have(key);
}

void JsonReader::must_have(const char* key) const {
  if (!value_.is_object()) expected("an object");
  if (!has(key)) refuse("the key \"" + std::string(key) + "\" is missing");
}

bool JsonReader::has(const char* key) const { return value_.contains(key); }

const std::string* JsonReader::string_or_null() const { return value_.get_ptr<const std::string*>(); }

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

double JsonReader::number(NumberRange range) const {
  if (!value_.is_number()) expected(description(range));
  const double number = value_.get<double>();
  if (!(number >= range.least && number <= range.most)) expected(description(range));
  return number;
}

bool JsonReader::boolean() const {
  if (!value_.is_boolean()) expected("true or false");
  return value_.get<bool>();
}

Vec JsonReader::vector(NumberRange range) const {
  if (!value_.is_array() || value_.size() != 2) expected("a list of two numbers, [x, y]");
  return {(*this)[std::size_t{0}].number(range), (*this)[std::size_t{1}].number(range)};
}

std::string JsonReader::text(std::size_t least, std::size_t most) const {
  const std::string* text = string_or_null();
  if (text == nullptr || text->size() < least || text->size() > most) {
    expected("a text of " + std::to_string(least) + " to " + std::to_string(most) + " bytes");
  }
  if (printable(*text, text->size()) != *text) refuse("expected one line of text, without control characters");
  return *text;
}

}  // namespace plumb
