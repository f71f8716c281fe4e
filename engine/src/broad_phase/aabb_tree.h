#pragma once

#include <cstdint>
#include <vector>

#include "impulse/math.h"

namespace impulse::inline IMPULSE_PRECISION {

/// A dynamic tree of bounding boxes: leaves are inserted and removed one at a time, and the tree stays short and tight.
///
/// A leaf is inserted where it adds least to the perimeters of the boxes above it; on the way back up, a node swaps a
/// child for a grandchild of the other side if that shrinks a box (Catto, "Dynamic bounding volume hierarchies", GDC
/// 2019).
class AabbTree {
 public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  /// Returns the handle of the leaf, valid until it is removed.
  std::uint32_t insert(const Aabb& bounds, std::uint32_t item, bool moves);
  void remove(std::uint32_t leaf);

  const Aabb& bounds(std::uint32_t leaf) const { return nodes_[leaf].bounds; }
  std::uint32_t item(std::uint32_t leaf) const { return nodes_[leaf].item; }
  void set_item(std::uint32_t leaf, std::uint32_t item) { nodes_[leaf].item = item; }
  /// Number of nodes on the longest path from the root to a leaf.
  int height() const;

  /// Calls visit(item) for every leaf whose bounds overlap the box. visit must not change the tree.
  template <class Visit>
  void visit(const Aabb& box, const Visit& visit) {
    stack_.clear();
    if (root_ != none) stack_.push_back({root_, root_});
    while (!stack_.empty()) {
      const Node& node = nodes_[stack_.back().first];
      stack_.pop_back();
      if (!overlap(node.bounds, box)) continue;
      if (node.leaf()) {
        visit(node.item);
      } else {
        stack_.push_back({node.left, node.left});
        stack_.push_back({node.right, node.right});
      }
    }
  }

  /// Calls visit(item, item) once for every two leaves whose bounds overlap and of which at least one moves.
  template <class Visit>
  void visit_pairs(const Visit& visit) {
    stack_.clear();
    if (root_ != none) stack_.push_back({root_, root_});
    while (!stack_.empty()) {
      const auto [a, b] = stack_.back();
      stack_.pop_back();
      if (a == b) {
        if (nodes_[a].leaf()) continue;
        push(nodes_[a].left, nodes_[a].left);
        push(nodes_[a].right, nodes_[a].right);
        push(nodes_[a].left, nodes_[a].right);
      } else if (nodes_[a].leaf() && nodes_[b].leaf()) {
        visit(nodes_[a].item, nodes_[b].item);
      } else if (nodes_[b].leaf() || (!nodes_[a].leaf() && perimeter(a) > perimeter(b))) {
        push(nodes_[a].left, b);
        push(nodes_[a].right, b);
      } else {
        push(a, nodes_[b].left);
        push(a, nodes_[b].right);
      }
    }
  }

 private:
  struct Node {
    Aabb bounds;
    std::uint32_t parent = none;
    std::uint32_t left = none;  // of a free node: the next free one
    std::uint32_t right = none;
    std::uint32_t item = 0;
    bool moves = false;  // any leaf below does

    bool leaf() const { return right == none; }
  };

  void push(std::uint32_t a, std::uint32_t b) {
    if (!nodes_[a].moves && !nodes_[b].moves) return;
    if (a == b || overlap(nodes_[a].bounds, nodes_[b].bounds)) stack_.push_back({a, b});
  }
  Real perimeter(std::uint32_t node) const;

  std::uint32_t take_node();
  void give_back(std::uint32_t node);
  std::uint32_t best_sibling(const Aabb& bounds) const;
  void replace_child(std::uint32_t parent, std::uint32_t child, std::uint32_t by);
  void refit(std::uint32_t node);
  void repair_upwards(std::uint32_t node);
  void rotate(std::uint32_t node);
  bool trade(std::uint32_t node, std::uint32_t child, std::uint32_t other);

  std::vector<Node> nodes_;
  std::uint32_t root_ = none;
  std::uint32_t free_ = none;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> stack_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
