#pragma once

#include <array>
#include <random>
#include <vector>

#include "impulse/shape.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The corners of a regular polygon centred at the origin.
inline std::vector<Vec2> ring(int corners, Real radius) {
  std::vector<Vec2> points(static_cast<std::size_t>(corners));
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = Rotation(static_cast<Real>(i) * 2 * pi / static_cast<Real>(corners)) * Vec2{radius, 0};
  }
  return points;
}

/// Random shapes and poses for property tests; the same seed gives the same sequence.
class RandomShapes {
 public:
  explicit RandomShapes(unsigned seed) : random_(seed) {}

  Real number(double low, double high) {
    // Not std::uniform_real_distribution<Real>, so that both precisions get the same shapes.
    const double unit = static_cast<double>(random_() >> 11) * 0x1p-53;
    return static_cast<Real>(low + (high - low) * unit);
  }
  std::vector<Vec2> points(std::size_t count, double reach) {
    std::vector<Vec2> all(count);
    for (Vec2& p : all) p = point(reach);
    return all;
  }
  Vec2 point(double reach) { return {number(-reach, reach), number(-reach, reach)}; }
  Pose pose(double reach) { return {point(reach), Rotation(number(-4, 4))}; }

  // The elements of a braced list are evaluated from left to right; the arguments of a call need not be.
  Shape shape(ShapeType type) {
    switch (type) {
      case ShapeType::circle: {
        const Real radius = number(0.1, 1);
        return Shape::circle(radius, point(0.3));
      }
      case ShapeType::box: {
        const Vec2 half{number(0.1, 1), number(0.1, 1)};
        const Vec2 center = point(0.3);
        return Shape::box(half, center, number(-2, 2));
      }
      case ShapeType::polygon:
        return polygon();
      case ShapeType::capsule: {
        const std::vector<Vec2> ends = points(2, 1);
        return Shape::capsule(ends[0], ends[1], number(0.1, 0.5));
      }
      case ShapeType::segment: {
        const std::vector<Vec2> ends = points(2, 1);
        return Shape::segment(ends[0], ends[1]);
      }
      case ShapeType::half_space: {
        const Vec2 normal = point(1);
        return Shape::half_space(normal, number(-1, 1));
      }
    }
    return {};
  }

 private:
  Shape polygon() {
    const int count = 3 + static_cast<int>(number(0, 5.99));
    std::vector<Vec2> corners(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Real angle = (static_cast<Real>(i) + number(0, 0.8)) * 2 * pi / static_cast<Real>(count);
      corners[i] = Rotation(angle) * Vec2{number(0.5, 1), 0};
    }
    return Shape::polygon(corners);
  }

  std::mt19937_64 random_;
};

inline constexpr std::array all_shape_types{ShapeType::circle,  ShapeType::box,     ShapeType::polygon,
                                            ShapeType::capsule, ShapeType::segment, ShapeType::half_space};

}  // namespace impulse::inline IMPULSE_PRECISION
