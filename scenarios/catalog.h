#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace plumb {

/// All entries of one kind (scenarios, engines, metrics, writers ...), each registered in its own file:
///
///     const Catalog<Scenario>::Entry entry{bounce()};
///
/// An Entry only stores the value: nothing may read a catalog before main. T needs a member `name`, unique in its
/// catalog. A member `group`, if T has one, becomes the name of the folder of the entry's file.
template <class T>
class Catalog {
 public:
  struct Entry {
    /// `file`: of the entry. GCC and clang; clang 14 has no std::source_location.
    explicit Entry(T value, const char* file = __builtin_FILE()) {
      if constexpr (requires { value.group = std::string(); }) value.group = folder_of(file);
      entries().push_back(std::move(value));
    }
    /// For an entry that depends on other entries: `make` is called when the catalog is first read, after main began.
    explicit Entry(T (*make)()) { makers().push_back(make); }
  };

  /// All entries, sorted by name, so that the link order of object files does not matter.
  static std::vector<const T*> all() {
    std::vector<const T*> sorted;
    for (const T& entry : complete()) sorted.push_back(&entry);
    std::sort(sorted.begin(), sorted.end(), [](const T* a, const T* b) { return a->name < b->name; });
    return sorted;
  }

  /// The entry with that name, or null if there is none.
  static const T* find(std::string_view name) {
    for (const T& entry : complete()) {
      if (entry.name == name) return &entry;
    }
    return nullptr;
  }

 private:
  static std::string folder_of(std::string_view file) {
    const std::string_view folder = file.substr(0, std::min(file.size(), file.rfind('/')));
    return std::string(folder.substr(folder.rfind('/') + 1));
  }

  static const std::vector<T>& complete() {
    static const std::vector<T>& all_entries = []() -> const std::vector<T>& {
      for (T (*make)() : makers()) entries().push_back(make());
      return entries();
    }();
    return all_entries;
  }

  static std::vector<T (*)()>& makers() {
    static std::vector<T (*)()> registered;
    return registered;
  }

  static std::vector<T>& entries() {
    static std::vector<T> registered;
    return registered;
  }
};

}  // namespace plumb
