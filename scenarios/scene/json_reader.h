#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scenarios/scene/scene.h"

/// Parsing of JSON files and checked access to their values. Every error is a std::invalid_argument that says where in
/// the file it is: "file: path: expected this, found that".
namespace plumb {

/// Why a scene file has no such word of another engine's format, and what to write instead: "motors are not in the
/// format", for example. "" for any other word. Case, - and _ don't count.
std::string foreign_word(std::string_view word);

/// Parses a JSON text (RFC 8259, UTF-8). Throws std::invalid_argument with line and column if the text is not JSON, and
/// with the path to the value for a duplicate key, a number beyond double precision, or nesting deeper than any of our
/// formats needs.
nlohmann::json parse_json(std::string_view text, std::string_view file);

/// Text that is safe to show in a message: at most `most` bytes, with control characters and broken UTF-8 replaced by
/// '?'.
std::string printable(std::string_view text, std::size_t most = 60);

/// The range of numbers that is accepted, both ends included.
struct NumberRange {
  double least = 0, most = 0;
  std::string_view unit = "";
};

/// One of the words that a value may be, and what it stands for.
template <class T>
struct Word {
  const char* word;
  T value;
};

/// The word for a value, or "" if the list has none.
template <class T, std::size_t n>
const char* word_for(const Word<T> (&words)[n], T value) {
  for (const Word<T>& word : words) {
    if (word.value == value) return word.word;
  }
  return "";
}

/// A value within a JSON text, and the path to it. All checks throw std::invalid_argument if the value does not pass.
class JsonReader {
 public:
  /// The top level. The value and the file name must outlive all readers made from it.
  JsonReader(const nlohmann::json& value, std::string_view file) : JsonReader(value, file, "") {}

  [[noreturn]] void refuse(const std::string& why) const;
  [[noreturn]] void expected(const std::string& what) const;

  /// Checks that this is an object with all the required keys and no others except the optional ones.
  void object(const std::vector<const char*>& required, const std::vector<const char*>& optional = {}) const;
  void must_have(const char* key) const;
  bool has(const char* key) const;
  JsonReader operator[](const char* key) const;

  /// Checks that this is a list and returns its length.
  std::size_t list() const;
  JsonReader operator[](std::size_t index) const;

  double number(NumberRange) const;
  bool boolean() const;
  Vec vector(NumberRange) const;
  /// One line without control characters, of `least` to `most` bytes.
  std::string text(std::size_t least, std::size_t most) const;

  template <class T>
  T one_of(std::span<const Word<T>> words) const {
    const std::string* given = string_or_null();
    std::vector<std::string> names;
    for (const Word<T>& word : words) {
      if (given != nullptr && *given == word.word) return word.value;
      names.emplace_back(word.word);
    }
    unknown_word(names);
  }

  /// The value for the word under "type", for objects that come in several kinds.
  template <class T>
  T kind(std::span<const Word<T>> words) const {
    must_have("type");
    return (*this)["type"].one_of<T>(words);
  }

  /// A member of an object, or `otherwise` if it is absent.
  double number(const char* key, double otherwise, NumberRange range) const {
    return has(key) ? (*this)[key].number(range) : otherwise;
  }
  bool boolean(const char* key, bool otherwise) const { return has(key) ? (*this)[key].boolean() : otherwise; }
  Vec vector(const char* key, Vec otherwise, NumberRange range) const {
    return has(key) ? (*this)[key].vector(range) : otherwise;
  }

  /// Refuses the word here because it is none of `names`.
  [[noreturn]] void unknown_word(const std::vector<std::string>& names, const char* what = "word") const;

  const nlohmann::json& value() const { return value_; }

 private:
  JsonReader(const nlohmann::json& value, std::string_view file, std::string path)
      : value_(value), file_(file), path_(std::move(path)) {}

  const std::string* string_or_null() const;

  const nlohmann::json& value_;
  std::string_view file_;
  std::string path_;
};

}  // namespace plumb
