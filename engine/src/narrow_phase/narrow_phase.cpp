#include "narrow_phase/narrow_phase.h"

#include <initializer_list>

namespace impulse::inline IMPULSE_PRECISION {

PairPoints points_of(const Manifold& manifold, Vec2 center_a, Vec2 center_b) {
  PairPoints points{};
  points.normal[0] = manifold.normal.x;
  points.normal[1] = manifold.normal.y;
  points.count = manifold.count;
  for (std::size_t p = 0; p < static_cast<std::size_t>(manifold.count); ++p) {
    const ManifoldPoint& from = manifold.points[p];
    const Vec2 arm_a = from.point - center_a;
    const Vec2 arm_b = from.point - center_b;
    std::size_t next = 0;
    for (const Real coordinate : {arm_a.x, arm_a.y, arm_b.x, arm_b.y}) points.arms[p][next++] = coordinate;
    points.separation[p] = from.separation;
    points.feature[p] = from.feature;
  }
  return points;
}

void NarrowPhase::collide(const BodySet& bodies, const ShapeTable& shapes, const Margin& margin,
                          std::span<const Pair> pairs, std::span<const std::uint32_t> items, PairPoints* found) {
  if (items.empty()) return;
  // By the kinds of both shapes: box, disc, other.
  enum Bin : std::uint8_t { boxes, box_with_disc, disc_with_box, discs, others };
  constexpr Bin bin_of[3][3] = {
      {boxes, box_with_disc, others}, {disc_with_box, discs, others}, {others, others, others}};
  const std::array<CollidePairs*, others> kernel{kernels_->collide_boxes, kernels_->collide_box_with_disc,
                                                 kernels_->collide_disc_with_box, kernels_->collide_discs};
  std::array<std::uint32_t*, others + 1> end{};
  for (std::size_t bin = 0; bin <= others; ++bin) {
    bins_[bin].resize(items.size());
    end[bin] = bins_[bin].data();
  }
  for (const std::uint32_t item : items) {
    const auto first = static_cast<std::size_t>(shapes.kind(pairs[item].first));
    const auto second = static_cast<std::size_t>(shapes.kind(pairs[item].second));
    *end[bin_of[first][second]]++ = item;
  }
  for (std::size_t bin = 0; bin < others; ++bin) {
    const auto count = static_cast<std::uint32_t>(end[bin] - bins_[bin].data());
    const PairBatch batch{shapes.records().data(), pairs.data(), bins_[bin].data(), count,
                          margin.distance,         margin.time};
    end[others] = kernel[bin](batch, found, end[others]);
  }
  for (const std::uint32_t* item = bins_[others].data(); item != end[others]; ++item) {
    const Pair& pair = pairs[*item];
    const std::size_t a = shapes.proxies()[pair.first].body;
    const std::size_t b = shapes.proxies()[pair.second].body;
    const Real impact_changes =
        shapes.records()[pair.first].impact_change + shapes.records()[pair.second].impact_change;
    const Manifold manifold =
        impulse::collide(shapes.part(pair.first).shape, bodies.pose[a], shapes.part(pair.second).shape, bodies.pose[b],
                         speculative_gap(bodies, a, b, margin) + margin.time * impact_changes);
    found[*item] = points_of(manifold, bodies.pose[a].p, bodies.pose[b].p);
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
