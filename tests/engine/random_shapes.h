#pragma once

#include <array>
#include <random>
#include <vector>

#include "impulse/shape.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Shapes and poses for property tests; the same seed gives the same ones.
class RandomShapes {
 public:
  explicit RandomShapes(unsigned seed) : random_(seed) {}

  Real number(double low, double high) {
    // Not std::uniform_real_distribution<Real>: both precisions should see the same shapes.
    const double unit = static_cast<double>(random_() >> 11) * 0x1p-53;
    return static_cast<Real>(low + (high - low) * unit);
  }
  Vec2 point(double reach) { return {number(-reach, reach), number(-reach, reach)}; }
  Pose pose(double reach) { return {point(reach), Rotation(number(-4, 4))}; }

  Shape shape(ShapeType type) {
    switch (type) {
      case ShapeType::circle:
        return Shape::circle(number(0.1, 1), point(0.3));
      case ShapeType::box:
        return Shape::box({number(0.1, 1), number(0.1, 1)}, point(0.3), number(-2, 2));
      case ShapeType::polygon:
        return polygon();
      case ShapeType::capsule:
        return Shape::capsule(point(1), point(1), number(0.1, 0.5));
      case ShapeType::segment:
        return Shape::segment(point(1), point(1));
      case ShapeType::half_space:
        return Shape::half_space(point(1), number(-1, 1));
    }
    return {};
  }

 private:
  Shape polygon() {
    const int count = 3 + static_cast<int>(number(0, 5.99));
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) {
      const Real angle = (static_cast<Real>(i) + number(0, 0.8)) * 2 * pi / static_cast<Real>(count);
      points.push_back(Rotation(angle) * Vec2{number(0.5, 1), 0});
    }
    return Shape::polygon(points);
  }

  std::mt19937_64 random_;
};

inline constexpr std::array all_shape_types{ShapeType::circle,  ShapeType::box,     ShapeType::polygon,
                                            ShapeType::capsule, ShapeType::segment, ShapeType::half_space};

}  // namespace impulse::inline IMPULSE_PRECISION
