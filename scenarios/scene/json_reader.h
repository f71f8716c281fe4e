#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scenarios/scene/scene.h"

namespace plumb {

/// Numbers that are accepted, both ends included.
struct Range {
  double least = 0, most = 0;
  std::string_view unit = "";
};

/// A choice of words, each with what it stands for.
template <class T>
struct Word {
  const char* word;
  T value;
};

/// A value within a JSON text and the path to it. What does not fit is refused by std::invalid_argument:
/// "file: path: expected this, found that".
class JsonReader {
 public:
  /// The top level. Value and file name must outlive all readers made from it.
  JsonReader(const nlohmann::json& value, std::string_view file) : JsonReader(value, file, "") {}

  [[noreturn]] void refuse(const std::string& why) const;
  [[noreturn]] void expected(const std::string& what) const;

  /// An object with all the required keys and no others but the optional ones.
  void object(const std::vector<const char*>& required, const std::vector<const char*>& optional = {}) const;
  void must_have(const char* key) const;
  bool has(const char* key) const { return value_.contains(key); }
  JsonReader operator[](const char* key) const;

  /// The length of a list.
  std::size_t list() const;
  JsonReader operator[](std::size_t index) const;

  double number(Range) const;
  bool boolean() const;
  Vec vector(Range) const;
  /// One line without control characters, of so many bytes.
  std::string text(std::size_t least, std::size_t most) const;

  template <class T>
  T one_of(std::span<const Word<T>> words) const {
    const std::string* given = value_.get_ptr<const std::string*>();
    std::vector<std::string> names;
    for (const Word<T>& word : words) {
      if (given != nullptr && *given == word.word) return word.value;
      names.emplace_back(word.word);
    }
    unknown_word(names);
  }

  /// The word under "type" of an object that comes in several kinds.
  template <class T>
  T kind(std::span<const Word<T>> words) const {
    must_have("type");
    return (*this)["type"].one_of<T>(words);
  }

  /// The same for what has a default.
  double number(const char* key, double otherwise, Range range) const {
    return has(key) ? (*this)[key].number(range) : otherwise;
  }
  bool boolean(const char* key, bool otherwise) const { return has(key) ? (*this)[key].boolean() : otherwise; }
  Vec vector(const char* key, Vec otherwise, Range range) const {
    return has(key) ? (*this)[key].vector(range) : otherwise;
  }

  /// Refuses the word here, which is none of these.
  [[noreturn]] void unknown_word(const std::vector<std::string>& names, const char* what = "word") const;

  const nlohmann::json& value() const { return value_; }

 private:
  JsonReader(const nlohmann::json& value, std::string_view file, std::string path)
      : value_(value), file_(file), path_(std::move(path)) {}

  const nlohmann::json& value_;
  std::string_view file_;
  std::string path_;
};

}  // namespace plumb
