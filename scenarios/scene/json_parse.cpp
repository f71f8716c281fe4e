#include "scenarios/scene/json_parse.h"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

namespace plumb {
namespace {

using Json = nlohmann::json;

constexpr std::size_t deepest = 16;  // a scene needs 6

// Takes what the parser meets and knows at any moment the path to it.
class Builder final : public nlohmann::json_sax<Json> {
 public:
  explicit Builder(std::string_view file) : file_(file) {}

  Json take() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }  // not in a text
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
    Json* value = nullptr;  // stays where it is: its parent grows no more until it is closed
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
    if (open_.size() == deepest) refuse("is nested deeper than anything in a scene");
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
        path += (path.empty() ? "" : ".") + printable(in.key);
      } else {
        // A list that is being read further down already holds what is read.
        path += "[" + std::to_string(in.value->size() - (&in == &open_.back() ? 0 : 1)) + "]";
      }
    }
    throw std::invalid_argument(file_ + ": " + (path.empty() ? "top level" : path) + ": " + why);
  }

  std::string file_;
  Json root_;
  std::vector<Open> open_;
};

// How many bytes of UTF-8 begin `text` as one character that may be shown; 0 if they do not.
std::size_t shown(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0u) == 0x80u; };
  const unsigned first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7F ? 1 : 0;
  if (first < 0xC2 || first > 0xF4) return 0;
  if (first == 0xC2 && byte(1) < 0xA0) return 0;  // control characters too
  const std::size_t length = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  for (std::size_t i = 1; i < length; ++i) {
    if (!follows(i)) return 0;
  }
  return length;
}

}  // namespace

std::string printable(std::string_view text, std::size_t most) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = shown(text);
    if (out.size() + std::max<std::size_t>(length, 1) > most) return out + "...";
    out += length == 0 ? "?" : text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

Json parse_json(std::string_view text, std::string_view file) {
  Builder builder(printable(file, text.npos));
  Json::sax_parse(text, &builder);
  return builder.take();
}

}  // namespace plumb
