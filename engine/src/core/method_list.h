#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "impulse/settings.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The solvers, integrators and broad phases of this build. Each joins from its own file:
///
///     const MethodList<Solver>::Entry entry{{"article", "...", "..."}, [] { return std::make_unique<Article>(); }};
///
/// A program can also supply methods of its own, by name, with extend(). Nothing reads a list before main, so the order
/// of joining does not matter.
template <class Method>
class MethodList {
 public:
  using Maker = std::function<std::unique_ptr<Method>()>;
  /// Makes a method by its name; null if it does not know the name.
  using Extension = std::function<std::unique_ptr<Method>(std::string_view name)>;

  struct Entry {
    Entry(MethodInfo info, Maker make) { joined().push_back({std::move(info), std::move(make)}); }
  };

  /// Methods that are not of this list are made by this function from now on; infos() does not include them.
  static void extend(Extension extension) { extended() = std::move(extension); }

  /// The methods of the list, sorted by name.
  static std::vector<MethodInfo> infos() {
    std::vector<MethodInfo> list;
    for (const Item& item : joined()) list.push_back(item.info);
    std::sort(list.begin(), list.end(), [](const MethodInfo& a, const MethodInfo& b) { return a.name < b.name; });
    return list;
  }

  static bool knows(std::string_view name) { return find(name) != nullptr || make_extended(name) != nullptr; }

  /// Makes the method of that name; null if there is none.
  static std::unique_ptr<Method> make(std::string_view name) {
    const Item* item = find(name);
    return item != nullptr ? item->make() : make_extended(name);
  }

 private:
  struct Item {
    MethodInfo info;
    Maker make;
  };
  static const Item* find(std::string_view name) {
    for (const Item& item : joined()) {
      if (item.info.name == name) return &item;
    }
    return nullptr;
  }
  static std::unique_ptr<Method> make_extended(std::string_view name) {
    return extended() ? extended()(name) : nullptr;
  }
  static std::vector<Item>& joined() {
    static std::vector<Item> list;
    return list;
  }
  static Extension& extended() {
    static Extension extension;
    return extension;
  }
};

}  // namespace impulse::inline IMPULSE_PRECISION
