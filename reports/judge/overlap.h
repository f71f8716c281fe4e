#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "reference/simulation.h"
#include "scenarios/scene/scene.h"
#include "scenarios/scene/shapes.h"

/// Gaps and overlaps of the scene's shapes, from the scene and the states alone.
namespace plumb {

struct Interval {
  double low = 0, high = 0;
};

/// The smallest and largest value of direction . p over the outline; `direction` has unit length. Returns nullopt for a
/// half-space, which is unbounded.
std::optional<Interval> range_along(Vec direction, const Outline&);

/// An outline whose points are kept elsewhere.
struct OutlineView {
  std::span<const Vec> points;
  double radius = 0;
  std::optional<HalfSpace> halfspace;
};

/// The gap between two outlines, m: their distance, or minus the depth by which one must be moved out of the other.
/// Infinite for two half-spaces.
double gap_between(const OutlineView&, const OutlineView&);
double gap_between(const Outline&, const Outline&);

/// Two bodies, the smaller index first, and how deep a part of one overlaps a part of the other.
struct BodyOverlap {
  std::size_t a = 0, b = 0;
  double depth = 0;  // m, > 0
};

/// Two bodies, the smaller index first, and the gap between a part of one and a part of the other.
struct BodyGap {
  std::size_t a = 0, b = 0;
  double gap = 0;                        // m, negative where they overlap
  std::size_t shape_a = 0, shape_b = 0;  // of the parts, indices into Body::shapes
  double reach = 0;                      // m, both bodies', up to which they were looked for
};

/// Gaps and overlaps of bodies. Pairs that may touch are measured: layers in common, at least one dynamic, no joint
/// between them. The scene must outlive it.
class Overlap {
 public:
  explicit Overlap(const Scene&);

  /// The parts whose gap is at most `reach[a] + reach[b]`, m; one reach >= 0 for every body.
  std::vector<BodyGap> near(std::span<const BodyState>, std::span<const double> reach) const;

  /// Every overlap of two parts.
  std::vector<BodyOverlap> all(std::span<const BodyState>) const;

  /// The deepest overlap; of depth 0 if nothing overlaps.
  BodyOverlap deepest(std::span<const BodyState>) const;

  /// The smallest gaps between bodies. Both it and the states must outlive what this returns.
  class Gaps;
  Gaps gaps(std::span<const BodyState>) const;

 private:
  struct Part {
    std::size_t body, shape;
    Outline outline;          // relative to the centre of mass
    std::size_t first_point;  // of all outlines' points, by part
    double reach;             // m, from its first point; infinite of a half-space
  };
  bool may_touch(std::size_t a, std::size_t b) const;
  /// Puts the points of a body's parts where its state says, into those of all parts.
  void place(std::size_t body, const BodyState&, std::span<Vec> points) const;
  OutlineView view(const Part&, const BodyState&, std::span<const Vec> points) const;

  const Scene& scene_;
  std::vector<Part> parts_;                                   // by body
  std::vector<std::size_t> first_part_;                       // of each body, and their number
  std::size_t points_ = 0;                                    // of all parts
  std::vector<std::pair<std::size_t, std::size_t>> jointed_;  // smaller index first, sorted
};

class Overlap::Gaps {
 public:
  Gaps(const Overlap&, std::span<const BodyState>);
  /// m, between two bodies, negative where they overlap; infinite if one has no shape.
  double between(std::size_t a, std::size_t b);

 private:
  double measured(std::size_t a, std::size_t b);

  const Overlap& overlap_;
  std::span<const BodyState> states_;
  std::vector<Vec> points_;   // of all parts, of a body once it is asked for
  std::vector<bool> placed_;  // by body
  std::map<std::pair<std::size_t, std::size_t>, double> known_;
};

}  // namespace plumb
