#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "impulse/settings.h"

namespace impulse::inline IMPULSE_PRECISION {

/// What is unlisted can be named and made, and is never offered: methods that are wrong on purpose (engine/faults).
enum class Offer : std::uint8_t { listed, unlisted };

/// The solvers, integrators and broad phases in this build. Each registers itself from its own file:
///
///     const MethodList<Solver>::Entry entry{{"article", "...", "..."}, [] { return std::make_unique<Article>(); }};
///
/// Nothing reads a list before main, so the order of registration does not matter.
template <class Method>
class MethodList {
 public:
  using Maker = std::function<std::unique_ptr<Method>()>;

  struct Entry {
    Entry(MethodInfo info, Maker make, Offer offer = Offer::listed) {
      joined().push_back({std::move(info), std::move(make), offer});
    }
  };

  static std::vector<MethodInfo> infos() {
    std::vector<MethodInfo> list;
    for (const Item& item : joined()) {
      if (item.offer == Offer::listed) list.push_back(item.info);
    }
    std::sort(list.begin(), list.end(), [](const MethodInfo& a, const MethodInfo& b) { return a.name < b.name; });
    return list;
  }

  static bool knows(std::string_view name) { return find(name) != nullptr; }

  /// Creates the method with this name; returns null if there is none.
  static std::unique_ptr<Method> make(std::string_view name) {
    const Item* item = find(name);
    return item == nullptr ? nullptr : item->make();
  }

 private:
  struct Item {
    MethodInfo info;
    Maker make;
    Offer offer;
  };
  static const Item* find(std::string_view name) {
    for (const Item& item : joined()) {
      if (item.info.name == name) return &item;
    }
    return nullptr;
  }
  static std::vector<Item>& joined() {
    static std::vector<Item> list;
    return list;
  }
};

}  // namespace impulse::inline IMPULSE_PRECISION
