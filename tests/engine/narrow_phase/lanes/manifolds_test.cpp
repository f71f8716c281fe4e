// The colliding kernels against their scalar twins, bit for bit.
#include "narrow_phase/lanes/manifolds.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <numeric>
#include <vector>

#include "../../random_shapes.h"
#include "narrow_phase/collide.h"
#include "narrow_phase/narrow_phase.h"
#include "narrow_phase/shape_table.h"

namespace impulse::inline IMPULSE_PRECISION::manifolds_test {

namespace {

/// Pairs of bodies of two types, and the manifolds by the colliders.
struct Pairs {
  BodySet bodies;
  ShapeTable shapes;
  Margin margin{static_cast<Real>(0.05), static_cast<Real>(0.02)};
  std::vector<Real> impact_changes;
  std::vector<Pair> pairs;

  void add(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b) {
    const auto first = static_cast<std::uint32_t>(bodies.size());
    pairs.push_back({first, first + 1});
    add(a, pose_a);
    add(b, pose_b);
  }

  std::vector<PairPoints> expected() const {
    std::vector<PairPoints> all;
    for (const Pair& pair : pairs) {
      const Pose& a = bodies.pose[pair.first];
      const Pose& b = bodies.pose[pair.second];
      const Real gap = speculative_gap(bodies, pair.first, pair.second, margin) +
                       margin.time * (impact_changes[pair.first] + impact_changes[pair.second]);
      all.push_back(points_of(collide(shape(pair.first), a, shape(pair.second), b, gap), a.p, b.p));
    }
    return all;
  }

  /// Compares each version of a kernel; returns the number of touching pairs.
  std::size_t compare(CollidePairs* NarrowPhaseKernels::*kernel, std::size_t most_left) {
    shapes.update(bodies, margin);
    shapes.grow(bodies, margin, impact_changes);
    const std::vector<PairPoints> right = expected();
    std::vector<std::uint32_t> items(pairs.size());
    std::iota(items.rbegin(), items.rend(), 0U);
    std::size_t touching = 0;
    for (const InstructionSet set : runnable_instruction_sets()) {
      std::vector<PairPoints> found(pairs.size());
      std::vector<std::uint32_t> left(pairs.size());
      const PairBatch batch{
          shapes.records().data(), pairs.data(), items.data(), static_cast<std::uint32_t>(items.size()),
          margin.distance,         margin.time};
      left.resize(static_cast<std::size_t>((narrow_phase_kernels(set).*kernel)(batch, found.data(), left.data()) -
                                           left.data()));
      EXPECT_LE(left.size(), most_left);
      for (const std::uint32_t item : left) found[item] = right[item];
      touching = 0;
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        EXPECT_TRUE(same(found[i], right[i])) << i;
        touching += found[i].count > 0 ? 1 : 0;
      }
    }
    return touching;
  }

 private:
  const Shape& shape(std::size_t body) const { return bodies.detail[body].parts[0].shape; }

  // Fixed, so that shapes stay off the centres of mass.
  void add(const Shape& shape, const Pose& pose) {
    BodyDef def;
    def.type = BodyType::fixed;
    const Part part{shape, {}};
    const std::size_t i = bodies.add(def, std::span(&part, 1)).index;
    bodies.insert(i);
    bodies.pose[i] = pose;
    bodies.velocity[i] = {{static_cast<Real>(i % 3), static_cast<Real>(i % 5)}, static_cast<Real>(i % 7)};
    impact_changes.push_back(static_cast<Real>(i % 4));
  }

  static bool same(Real a, Real b) {
    using Bits = std::conditional_t<sizeof(Real) == 8, std::uint64_t, std::uint32_t>;
    return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b) || (std::isnan(a) && std::isnan(b));
  }
  static bool same(const PairPoints& a, const PairPoints& b) {
    if (a.count != b.count) return false;
    if (a.count == 0) return true;
    bool equal = same(a.normal[0], b.normal[0]) && same(a.normal[1], b.normal[1]);
    for (std::size_t p = 0; p < static_cast<std::size_t>(a.count); ++p) {
      equal &= same(a.separation[p], b.separation[p]) && a.feature[p] == b.feature[p];
      for (std::size_t i = 0; i < 4; ++i) equal &= same(a.arms[p][i], b.arms[p][i]);
    }
    return equal;
  }
};

struct Kind {
  const char* name;
  CollidePairs* NarrowPhaseKernels::*kernel;
  ShapeType first, second;
};

const std::array kinds{
    Kind{"boxes", &NarrowPhaseKernels::collide_boxes, ShapeType::box, ShapeType::box},
    Kind{"discs", &NarrowPhaseKernels::collide_discs, ShapeType::circle, ShapeType::circle},
    Kind{"disc_with_box", &NarrowPhaseKernels::collide_disc_with_box, ShapeType::circle, ShapeType::box},
    Kind{"box_with_disc", &NarrowPhaseKernels::collide_box_with_disc, ShapeType::box, ShapeType::circle},
};

class CollidingKernels : public testing::TestWithParam<Kind> {};

TEST_P(CollidingKernels, AgreeWithTheCollidersOnRandomPairs) {
  RandomShapes random(1);
  Pairs pairs;
  constexpr std::size_t count = 20000;
  for (std::size_t i = 0; i < count; ++i) {
    const Shape a = random.shape(GetParam().first);
    const Shape b = random.shape(GetParam().second);
    const Pose pose_a = random.pose(i % 2 == 0 ? 1 : 1.5);
    const Pose pose_b = random.pose(1);
    pairs.add(a, pose_a, b, pose_b);
  }
  EXPECT_GT(pairs.compare(GetParam().kernel, count / 50), count / 4);
}

/// On a grid, rotated by quarter turns or very little: faces lie on faces, corners on corners, centres on centres.
TEST_P(CollidingKernels, AgreeWithTheCollidersOnAlignedPairs) {
  RandomShapes random(2);
  const auto half = [&random](int most) {
    return Real{0.5} * static_cast<Real>(static_cast<int>(random.number(0, most + .99)));
  };
  const auto sized = [&](ShapeType type) {
    const Real x = Real{0.5} + half(1);
    return type == ShapeType::box ? Shape::box({x, Real{0.5} + half(1)}) : Shape::circle(x);
  };
  const std::array turns{
      Rotation(1, 0),  Rotation(0, 1), Rotation(-1, 0), Rotation(0, -1), Rotation(static_cast<Real>(1e-3)),
      Rotation(pi / 4)};
  const auto turn = [&] { return turns[static_cast<std::size_t>(random.number(0, 5.99))]; };
  Pairs pairs;
  constexpr std::size_t count = 20000;
  for (std::size_t i = 0; i < count; ++i) {
    const Shape a = sized(GetParam().first);
    const Shape b = sized(GetParam().second);
    const Pose pose_a{{half(4), half(4)}, turn()};
    const Pose pose_b{{half(4), half(4)}, turn()};
    pairs.add(a, pose_a, b, pose_b);
  }
  EXPECT_GT(pairs.compare(GetParam().kernel, count / 5), count / 4);
}

/// Boxes that lie on each other up to rounding, of very different size, far from the origin.
TEST_P(CollidingKernels, AgreeWithTheCollidersNearRounding) {
  RandomShapes random(3);
  const auto sized = [&](ShapeType type) {
    const auto scale = static_cast<Real>(std::pow(10, static_cast<double>(random.number(-3, 2))));
    return type == ShapeType::box ? Shape::box({scale, scale * random.number(.01, 1)}) : Shape::circle(scale);
  };
  Pairs pairs;
  pairs.margin = {};
  constexpr std::size_t count = 10000;
  for (std::size_t i = 0; i < count; ++i) {
    const Shape a = sized(GetParam().first);
    const Shape b = sized(GetParam().second);
    const Vec2 far = random.point(i % 2 == 0 ? 1e4 : 1);
    const Pose pose_a{far, Rotation(random.number(-1e-3, 1e-3))};
    const Real aside = i % 4 < 2 ? 0 : random.number(-1, 1);
    const auto reach = [](const Shape& shape) {
      return shape.type() == ShapeType::box ? shape.half_extents().y : shape.radius();
    };
    const Pose pose_b{far + Vec2{aside * a.extent(), reach(a) + reach(b)}, Rotation(random.number(-1e-6, 1e-6))};
    pairs.add(a, pose_a, b, pose_b);
  }
  EXPECT_GT(pairs.compare(GetParam().kernel, count), count / 10);
}

/// NaN and infinity give the same result in lanes.
TEST_P(CollidingKernels, AgreeWithTheCollidersOnNan) {
  constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
  constexpr Real inf = std::numeric_limits<Real>::infinity();
  RandomShapes random(4);
  Pairs pairs;
  for (const Real odd : {nan, inf, -inf, std::numeric_limits<Real>::max()}) {
    for (int i = 0; i < 20; ++i) {
      const Shape a = random.shape(GetParam().first);
      const Shape b = random.shape(GetParam().second);
      Pose pose_a = random.pose(1);
      Pose pose_b = random.pose(1);
      Real* const places[] = {&pose_a.p.x, &pose_b.p.y, &pose_a.q.c, &pose_b.q.s};
      *places[i % 4] = odd;
      pairs.add(a, pose_a, b, pose_b);
    }
  }
  pairs.compare(GetParam().kernel, pairs.pairs.size());
}

INSTANTIATE_TEST_SUITE_P(Kernels, CollidingKernels, testing::ValuesIn(kinds),
                         [](const auto& kind) { return std::string(kind.param.name); });

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION::manifolds_test
