#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "impulse/settings.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The solvers, integrators and broad phases that this build holds. Each joins from its own file:
///
///     const MethodList<Solver>::Entry entry{{"article", "...", "..."}, [] { return std::make_unique<Article>(); }};
///
/// Nothing reads a list before main, so the order of joining does not matter.
template <class Method>
class MethodList {
 public:
  using Maker = std::function<std::unique_ptr<Method>()>;

  struct Entry {
    Entry(MethodInfo info, Maker make) { joined().push_back({std::move(info), std::move(make)}); }
  };

  static std::vector<MethodInfo> infos() {
    std::vector<MethodInfo> list;
    for (const Item& item : joined()) list.push_back(item.info);
    std::sort(list.begin(), list.end(), [](const MethodInfo& a, const MethodInfo& b) { return a.name < b.name; });
    return list;
  }

  /// The method of that name, newly made; null if there is none.
  static std::unique_ptr<Method> make(std::string_view name) {
    for (const Item& item : joined()) {
      if (item.info.name == name) return item.make();
    }
    return nullptr;
  }

 private:
  struct Item {
    MethodInfo info;
    Maker make;
  };
  static std::vector<Item>& joined() {
    static std::vector<Item> list;
    return list;
  }
};

}  // namespace impulse::inline IMPULSE_PRECISION
