#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace plumb {

/// A partition of bodies that starts with each alone (union-find).
class Groups {
 public:
  explicit Groups(std::size_t bodies) : parents_(bodies) {
    std::iota(parents_.begin(), parents_.end(), std::size_t{0});
  }

  void join(std::size_t a, std::size_t b) { parents_[of(a)] = of(b); }

  /// The same index for all bodies of a group.
  std::size_t of(std::size_t body) {
    while (parents_[body] != body) body = parents_[body] = parents_[parents_[body]];
    return body;
  }

 private:
  std::vector<std::size_t> parents_;
};

}  // namespace plumb
