#pragma once

#include "core/simd.h"
#include "narrow_phase/lanes/manifolds.h"

/// The vector algebra of the kernels that collide pairs of shapes, one pair in each lane.
namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

inline Lanes::Mask select(const Lanes::Mask& mask, const Lanes::Mask& yes, const Lanes::Mask& no) {
  return (mask & yes) | (no & !mask);
}

struct Vec2Lanes {
  Lanes x, y;

  friend Vec2Lanes operator+(const Vec2Lanes& a, const Vec2Lanes& b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec2Lanes operator-(const Vec2Lanes& a, const Vec2Lanes& b) { return {a.x - b.x, a.y - b.y}; }
  friend Vec2Lanes operator-(const Vec2Lanes& a) { return {-a.x, -a.y}; }
  friend Vec2Lanes operator*(const Lanes& s, const Vec2Lanes& a) { return {s * a.x, s * a.y}; }
  friend Vec2Lanes operator/(const Vec2Lanes& a, const Lanes& s) { return {a.x / s, a.y / s}; }
};

inline Lanes dot(const Vec2Lanes& a, const Vec2Lanes& b) { return a.x * b.x + a.y * b.y; }
inline Lanes length_squared(const Vec2Lanes& a) { return dot(a, a); }
inline Lanes length(const Vec2Lanes& a) { return sqrt(dot(a, a)); }
inline Vec2Lanes perpendicular(const Vec2Lanes& a) { return {-a.y, a.x}; }
inline Vec2Lanes select(const Lanes::Mask& mask, const Vec2Lanes& yes, const Vec2Lanes& no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y)};
}

struct RotationLanes {
  Lanes c, s;

  friend Vec2Lanes operator*(const RotationLanes& q, const Vec2Lanes& v) {
    return {q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y};
  }
  friend RotationLanes operator*(const RotationLanes& q, const RotationLanes& r) {
    return {q.c * r.c - q.s * r.s, q.s * r.c + q.c * r.s};
  }
  RotationLanes inverse() const { return {c, -s}; }
};

inline RotationLanes select(const Lanes::Mask& mask, const RotationLanes& yes, const RotationLanes& no) {
  return {select(mask, yes.c, no.c), select(mask, yes.s, no.s)};
}

/// The ShapeRecords of the lanes, except for their motion.
struct ShapeLanes {
  Vec2Lanes position, offset;
  RotationLanes turn;
  Vec2Lanes size;
};

inline ShapeLanes select(const Lanes::Mask& mask, const ShapeLanes& yes, const ShapeLanes& no) {
  return {select(mask, yes.position, no.position), select(mask, yes.offset, no.offset), select(mask, yes.turn, no.turn),
          select(mask, yes.size, no.size)};
}

/// One pair of a batch for each lane; the last pair is repeated if fewer are left.
class PairLanes {
 public:
  PairLanes(const PairBatch& batch, std::uint32_t from) : batch_(batch), from_(from) {
    const std::uint32_t count = batch.count - from;
    present_ = first_lanes(count);
    for (std::uint32_t lane = 0; lane < lane_count; ++lane) {
      const Pair& pair = batch.pairs[batch.items[from + (lane < count ? lane : count - 1)]];
      rows_a_[lane] = &batch.shapes[pair.first].position.x;
      rows_b_[lane] = &batch.shapes[pair.second].position.x;
    }
  }

  ShapeLanes first() const { return shape(rows_a_); }
  ShapeLanes second() const { return shape(rows_b_); }

  struct Motion {
    Vec2Lanes velocity;
    Lanes rim, impact_change;
  };
  Motion first_motion() const { return motion(rows_a_); }
  Motion second_motion() const { return motion(rows_b_); }

  /// The gap up to which points count, see speculative_gap().
  Lanes margin() const {
    const Lanes distance = Lanes::all(batch_.distance);
    if (batch_.time == 0) return distance;
    const Motion a = first_motion();
    const Motion b = second_motion();
    const Lanes time = Lanes::all(batch_.time);
    return distance + time * (length(b.velocity - a.velocity) + (a.rim + b.rim)) +
           time * (a.impact_change + b.impact_change);
  }

  /// Bits of the lanes that hold a pair.
  std::uint32_t present() const { return present_; }
  std::uint32_t item(std::uint32_t lane) const { return batch_.items[from_ + lane]; }

  /// Writes that no pair has points.
  void clear(PairPoints* found) const {
    const std::uint32_t count = batch_.count - from_;
    for (std::uint32_t lane = 0; lane < lane_count && lane < count; ++lane) found[item(lane)].count = 0;
  }
  /// Adds the items of some lanes to a list.
  std::uint32_t* leave(std::uint32_t lanes, std::uint32_t* to) const {
    for (std::uint32_t left = lanes & present_; left != 0; left &= left - 1) {
      *to++ = item(static_cast<std::uint32_t>(__builtin_ctz(left)));
    }
    return to;
  }

 private:
  static void gather(const Real* const* rows, std::uint32_t from, Lanes columns[4]) {
    const Real* at[lane_count];
    for (std::uint32_t lane = 0; lane < lane_count; ++lane) at[lane] = rows[lane] + from;
    Lanes::gather(at, columns);
  }
  static ShapeLanes shape(const Real* const* rows) {
    Lanes low[4];
    Lanes high[4];
    gather(rows, 0, low);
    gather(rows, 4, high);
    return {{low[0], low[1]}, {low[2], low[3]}, {high[0], high[1]}, {high[2], high[3]}};
  }
  static Motion motion(const Real* const* rows) {
    Lanes columns[4];
    gather(rows, 8, columns);
    return {{columns[0], columns[1]}, columns[2], columns[3]};
  }

  const PairBatch& batch_;
  std::uint32_t from_;
  std::uint32_t present_;
  const Real* rows_a_[lane_count];
  const Real* rows_b_[lane_count];
};

/// Exactly one of in_order(a, b) and in_order(b, a) (see collide.cpp), as far as the first criterion decides.
struct OrderLanes {
  Lanes::Mask swapped, known;

  explicit OrderLanes(const Vec2Lanes& a_to_b) {
    constexpr Real slanted_x = static_cast<Real>(0.52573);
    constexpr Real slanted_y = static_cast<Real>(0.85065);
    const Lanes rise = Lanes::all(slanted_x) * a_to_b.x + Lanes::all(slanted_y) * a_to_b.y;
    swapped = rise < Lanes::all(0);
    known = swapped | (Lanes::all(0) < rise);
  }
};

/// The points found in each lane.
struct PointsLanes {
  Vec2Lanes normal;
  Lanes separation[2];
  Vec2Lanes point[2];  // world frame
  Lanes code;          // count + 4 (corner of a + 4 of b, of the first point) + 64 (of the second)

  void write(const PairLanes& pairs, const Vec2Lanes& center_a, const Vec2Lanes& center_b, PairPoints* found) const {
    PairPoints nobody;
    PairPoints* to[lane_count];
    for (std::uint32_t lane = 0; lane < lane_count; ++lane) {
      to[lane] = (pairs.present() >> lane & 1U) != 0 ? &found[pairs.item(lane)] : &nobody;
    }
    Real* rows[lane_count];
    for (std::uint32_t lane = 0; lane < lane_count; ++lane) rows[lane] = to[lane]->normal;
    const Lanes head[4] = {normal.x, normal.y, separation[0], separation[1]};
    Lanes::scatter(head, rows);
    for (std::uint32_t p = 0; p < 2; ++p) {
      for (std::uint32_t lane = 0; lane < lane_count; ++lane) rows[lane] = to[lane]->arms[p];
      const Vec2Lanes arm_a = point[p] - center_a;
      const Vec2Lanes arm_b = point[p] - center_b;
      const Lanes arms[4] = {arm_a.x, arm_a.y, arm_b.x, arm_b.y};
      Lanes::scatter(arms, rows);
    }
    Real codes[lane_count];
    code.store(codes);
    for (std::uint32_t lane = 0; lane < lane_count; ++lane) {
      const auto all = static_cast<std::uint32_t>(static_cast<std::int32_t>(codes[lane]));
      to[lane]->count = static_cast<std::int32_t>(all & 3U);
      to[lane]->feature[0] = feature(all >> 2U);
      to[lane]->feature[1] = feature(all >> 6U);
    }
  }

 private:
  static std::uint32_t feature(std::uint32_t corners) { return (corners & 3U) | (corners & 12U) << 6U; }
};

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
