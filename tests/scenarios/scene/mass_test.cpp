#include "scenarios/scene/mass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace plumb::mass_test {
namespace {

Body with(Geometry geometry, double density = 1) {
  return {.shapes = {{.geometry = std::move(geometry), .surface = {.density = density}}}};
}

// The same integrals by brute force: the midpoint rule over strips, with an error of at most order 1/strips^2 for
// smooth edges.
Mass integrate(double x0, double x1, const std::function<std::pair<double, double>(double)>& column) {
  constexpr int strips = 200000;
  const double dx = (x1 - x0) / strips;
  double area = 0, sx = 0, sy = 0, second = 0;
  for (int i = 0; i < strips; ++i) {
    const double x = x0 + (i + 0.5) * dx;
    const auto [low, high] = column(x);
    const double h = high - low;
    area += h * dx;
    sx += x * h * dx;
    sy += (high * high - low * low) / 2 * dx;
    second += (x * x * h + (high * high * high - low * low * low) / 3) * dx;
  }
  const Vec c{sx / area, sy / area};
  return {area, second - area * (c.x * c.x + c.y * c.y), c};
}

TEST(MassOf, ADiscHasHalfMRSquared) {
  const Mass mass = mass_of(with(Circle{.radius = 2, .center = {3, 4}}, 5));
  EXPECT_DOUBLE_EQ(mass.mass, 20 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(mass.inertia, mass.mass * 2);
  EXPECT_EQ(mass.center, (Vec{3, 4}));
}

TEST(MassOf, ABoxHasTheSameMassAtEveryAngle) {
  const Mass mass = mass_of(with(Box{.size = {3, 2}, .center = {1, 0}, .angle = 0.7}, 2));
  EXPECT_DOUBLE_EQ(mass.mass, 12);
  EXPECT_DOUBLE_EQ(mass.inertia, 13);
  EXPECT_EQ(mass.center, (Vec{1, 0}));
}

TEST(MassOf, APolygonWithFourCornersIsABoxInBothWindings) {
  const Vec corners[] = {{100, 50}, {103, 50}, {103, 52}, {100, 52}};
  const Mass there = mass_of(with(Polygon{{corners[0], corners[1], corners[2], corners[3]}}));
  const Mass back = mass_of(with(Polygon{{corners[3], corners[2], corners[1], corners[0]}}));
  for (const Mass& mass : {there, back}) {
    EXPECT_DOUBLE_EQ(mass.mass, 6);
    EXPECT_NEAR(mass.inertia, 6.5, 1e-14);
    EXPECT_NEAR(mass.center.x, 101.5, 1e-13);
    EXPECT_NEAR(mass.center.y, 51, 1e-13);
  }
}

TEST(MassOf, ATriangleMatchesItsIntegral) {
  const Mass mass = mass_of(with(Polygon{{{0, 0}, {3, 0}, {3, 2}}}));
  const Mass sum = integrate(0, 3, [](double x) { return std::pair{0.0, 2 * x / 3}; });
  EXPECT_NEAR(mass.mass, sum.mass, 1e-9);
  EXPECT_NEAR(mass.inertia, sum.inertia, 1e-9);
  EXPECT_NEAR(mass.center.x, sum.center.x, 1e-9);
  EXPECT_NEAR(mass.center.y, sum.center.y, 1e-9);
}

TEST(MassOf, ACapsuleMatchesItsIntegral) {
  const double r = 0.5;
  const Mass mass = mass_of(with(Capsule{.from = {-1, 0}, .to = {1, 0}, .radius = r}));
  const Mass sum = integrate(-1 - r, 1 + r, [r](double x) {
    const double beyond = std::max(std::abs(x) - 1, 0.0);
    const double y = std::sqrt(r * r - beyond * beyond);
    return std::pair{-y, y};
  });
  // The vertical tangents at a circle's ends reduce the midpoint rule to order 3/2: (2 (1 + r)/200000)^1.5.
  EXPECT_NEAR(mass.mass, sum.mass, 1e-7);
  EXPECT_NEAR(mass.inertia, sum.inertia, 1e-7);
  EXPECT_NEAR(mass.center.x, 0, 1e-15);
}

TEST(MassOf, ACapsuleWithoutLengthIsADisc) {
  const Mass capsule = mass_of(with(Capsule{.from = {1, 1}, .to = {1, 1}, .radius = 2}));
  const Mass disc = mass_of(with(Circle{.radius = 2, .center = {1, 1}}));
  EXPECT_DOUBLE_EQ(capsule.mass, disc.mass);
  EXPECT_DOUBLE_EQ(capsule.inertia, disc.inertia);
}

TEST(MassOf, TwoHalvesHaveTheMassOfTheWhole) {
  Body halves = with(Box{.size = {1, 2}, .center = {0.5, 0}});
  halves.shapes.push_back({.geometry = Box{.size = {1, 2}, .center = {-0.5, 0}}, .surface = {}});
  const Mass sum = mass_of(halves);
  const Mass whole = mass_of(with(Box{.size = {2, 2}}));
  EXPECT_DOUBLE_EQ(sum.mass, whole.mass);
  EXPECT_DOUBLE_EQ(sum.inertia, whole.inertia);
  EXPECT_NEAR(sum.center.x, 0, 1e-16);
}

TEST(MassOf, TheCentreIsCloserToTheDenserPart) {
  Body body = with(Circle{.radius = 1, .center = {-1, 0}}, 1);
  body.shapes.push_back({.geometry = Circle{.radius = 1, .center = {1, 0}}, .surface = {.density = 3}});
  const Mass mass = mass_of(body);
  EXPECT_DOUBLE_EQ(mass.center.x, 0.5);
  // Each disc's own m/2, and the reduced mass 3/4 pi at a distance of 2.
  EXPECT_DOUBLE_EQ(mass.inertia, std::numbers::pi * (0.5 + 1.5 + 3));
}

TEST(MassOf, ABodyThatCannotMoveHasNoMass) {
  Body body = with(Box{.size = {1, 1}, .center = {5, 5}});
  body.fixed_rotation = true;
  EXPECT_DOUBLE_EQ(mass_of(body).mass, 1);
  EXPECT_EQ(mass_of(body).inertia, 0);
  for (const BodyType type : {BodyType::fixed, BodyType::kinematic}) {
    body.type = type;
    EXPECT_EQ(mass_of(body).mass, 0);
    EXPECT_EQ(mass_of(body).center, Vec{});
  }
}

TEST(MassOf, SegmentsAndHalfSpacesHaveNoMass) {
  EXPECT_EQ(mass_of(with(Segment{{0, 0}, {1, 0}})).mass, 0);
  EXPECT_EQ(mass_of(with(HalfSpace{})).mass, 0);
}

}  // namespace
}  // namespace plumb::mass_test
