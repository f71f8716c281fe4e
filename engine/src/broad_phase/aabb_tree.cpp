#include "broad_phase/aabb_tree.h"

#include <algorithm>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

// Half the perimeter: proportional to the chance that a small box overlaps this one.
Real perimeter_of(const Aabb& box) { return (box.high.x - box.low.x) + (box.high.y - box.low.y); }

}  // namespace

Real AabbTree::perimeter(std::uint32_t node) const { return perimeter_of(nodes_[node].bounds); }

std::uint32_t AabbTree::take_node() {
  if (free_ == none) {
    nodes_.emplace_back();
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }
  const std::uint32_t node = free_;
  free_ = nodes_[node].left;
  nodes_[node] = Node{};
  return node;
}

void AabbTree::give_back(std::uint32_t node) {
  nodes_[node] = Node{};
  nodes_[node].left = free_;
  free_ = node;
}

// Descends while a child promises a lower cost than becoming the sibling of the node itself. `inherited` is the growth
// of all boxes above.
std::uint32_t AabbTree::best_sibling(const Aabb& bounds) const {
  std::uint32_t node = root_;
  Real inherited = 0;
  while (!nodes_[node].leaf()) {
    const Real joint = perimeter_of(merged(nodes_[node].bounds, bounds));
    const Real here = joint + inherited;
    inherited += joint - perimeter(node);
    const auto cost_below = [&](std::uint32_t child) {
      const Real grown_child = perimeter_of(merged(nodes_[child].bounds, bounds));
      return inherited + (nodes_[child].leaf() ? grown_child : grown_child - perimeter(child));
    };
    const Real left = cost_below(nodes_[node].left);
    const Real right = cost_below(nodes_[node].right);
    if (here < left && here < right) break;
    node = left < right ? nodes_[node].left : nodes_[node].right;
  }
  return node;
}

std::uint32_t AabbTree::insert(const Aabb& bounds, std::uint32_t item, bool moves) {
  const std::uint32_t leaf = take_node();
  nodes_[leaf].bounds = bounds;
  nodes_[leaf].item = item;
  nodes_[leaf].moves = moves;
  if (root_ == none) {
    root_ = leaf;
    return leaf;
  }
  const std::uint32_t sibling = best_sibling(bounds);
  const std::uint32_t parent = take_node();
  const std::uint32_t above = nodes_[sibling].parent;
  replace_child(above, sibling, parent);
  nodes_[parent].left = sibling;
  nodes_[parent].right = leaf;
  nodes_[sibling].parent = parent;
  nodes_[leaf].parent = parent;
  repair_upwards(parent);
  return leaf;
}

void AabbTree::remove(std::uint32_t leaf) {
  const std::uint32_t parent = nodes_[leaf].parent;
  if (parent == none) {
    root_ = none;
  } else {
    const std::uint32_t sibling = nodes_[parent].left == leaf ? nodes_[parent].right : nodes_[parent].left;
    const std::uint32_t above = nodes_[parent].parent;
    replace_child(above, parent, sibling);
    give_back(parent);
    repair_upwards(above);
  }
  give_back(leaf);
}

// Replaces `child` of `parent` by another node, which becomes the root if there is no parent.
void AabbTree::replace_child(std::uint32_t parent, std::uint32_t child, std::uint32_t by) {
  nodes_[by].parent = parent;
  if (parent == none) {
    root_ = by;
  } else if (nodes_[parent].left == child) {
    nodes_[parent].left = by;
  } else {
    nodes_[parent].right = by;
  }
}

void AabbTree::refit(std::uint32_t node) {
  Node& n = nodes_[node];
  n.bounds = merged(nodes_[n.left].bounds, nodes_[n.right].bounds);
  n.moves = nodes_[n.left].moves || nodes_[n.right].moves;
}

void AabbTree::repair_upwards(std::uint32_t node) {
  for (; node != none; node = nodes_[node].parent) {
    rotate(node);
    refit(node);
  }
}

void AabbTree::rotate(std::uint32_t node) {
  const std::uint32_t left = nodes_[node].left;
  const std::uint32_t right = nodes_[node].right;
  if (!trade(node, left, right)) trade(node, right, left);
}

// Swaps `child` with a child of its sibling `other` if that makes the box of `other` smaller.
bool AabbTree::trade(std::uint32_t node, std::uint32_t child, std::uint32_t other) {
  if (nodes_[other].leaf()) return false;
  const std::uint32_t near = nodes_[other].left;
  const std::uint32_t far = nodes_[other].right;
  const Real with_near = perimeter_of(merged(nodes_[child].bounds, nodes_[near].bounds));  // far goes up
  const Real with_far = perimeter_of(merged(nodes_[child].bounds, nodes_[far].bounds));
  if (std::min(with_near, with_far) >= perimeter(other)) return false;
  const std::uint32_t up = with_near < with_far ? far : near;
  replace_child(node, child, up);
  replace_child(other, up, child);
  refit(other);
  return true;
}

int AabbTree::height() const {
  std::vector<std::pair<std::uint32_t, int>> stack;
  if (root_ != none) stack.push_back({root_, 1});
  int highest = 0;
  while (!stack.empty()) {
    const auto [node, depth] = stack.back();
    stack.pop_back();
    highest = std::max(highest, depth);
    if (nodes_[node].leaf()) continue;
    stack.push_back({nodes_[node].left, depth + 1});
    stack.push_back({nodes_[node].right, depth + 1});
  }
  return highest;
}

}  // namespace impulse::inline IMPULSE_PRECISION
