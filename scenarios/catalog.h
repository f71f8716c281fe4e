#pragma once

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace plumb {

/// All entries of one kind (scenarios, engines, metrics, writers ...), each joined from its own file:
///
///     const Catalog<Scenario>::Entry entry{bounce()};
///
/// An entry only stores; nothing may read a catalog before main. T needs a member `name`, unique in its catalog.
template <class T>
class Catalog {
 public:
  struct Entry {
    explicit Entry(T value) { entries().push_back(std::move(value)); }
    /// For an entry that itself asks what others have joined: made when the catalog is first read, after main began.
    explicit Entry(T (*make)()) { makers().push_back(make); }
  };

  /// Every entry, sorted by name: the order in which object files were linked never shows.
  static std::vector<const T*> all() {
    std::vector<const T*> sorted;
    for (const T& entry : complete()) sorted.push_back(&entry);
    std::sort(sorted.begin(), sorted.end(), [](const T* a, const T* b) { return a->name < b->name; });
    return sorted;
  }

  /// The entry of that name, or null.
  static const T* find(std::string_view name) {
    for (const T& entry : complete()) {
      if (entry.name == name) return &entry;
    }
    return nullptr;
  }

 private:
  static const std::vector<T>& complete() {
    static const std::vector<T>& all_made = []() -> const std::vector<T>& {
      for (T (*make)() : makers()) entries().push_back(make());
      return entries();
    }();
    return all_made;
  }

  static std::vector<T (*)()>& makers() {
    static std::vector<T (*)()> joined;
    return joined;
  }

  static std::vector<T>& entries() {
    static std::vector<T> joined;
    return joined;
  }
};

}  // namespace plumb
