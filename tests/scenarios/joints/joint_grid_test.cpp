#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/scenarios/statement_of.h"

namespace plumb::joint_grid_test {
namespace {

using statement_of::Of;

// The number of independent rows, by elimination with full pivoting.
std::size_t rank(std::vector<std::vector<double>> rows) {
  std::size_t found = 0;
  const std::size_t columns = rows.front().size();
  std::vector<bool> used(columns, false);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::size_t row = found;
    std::size_t column = 0;
    double largest = 1e-9;
    for (std::size_t r = found; r < rows.size(); ++r) {
      for (std::size_t c = 0; c < columns; ++c) {
        if (used[c] || std::abs(rows[r][c]) <= largest) continue;
        largest = std::abs(rows[r][c]);
        row = r;
        column = c;
      }
    }
    if (largest == 1e-9) break;
    std::swap(rows[found], rows[row]);
    used[column] = true;
    for (std::size_t r = found + 1; r < rows.size(); ++r) {
      const double factor = rows[r][column] / rows[found][column];
      for (std::size_t c = 0; c < columns; ++c) rows[r][c] -= factor * rows[found][c];
    }
    ++found;
  }
  return found;
}

// Each hinge says that its point has the same velocity on both discs: two equations in the velocities (x, y, spin) of
// all discs that are not fixed. Of full rank, they leave no motion.
TEST(JointGrid, IsRigidForAnyNumberOfDiscs) {
  const Scenario& family = *Catalog<Scenario>::find("joint-grid");
  for (const double side : {3.0, 5.0, 7.0}) {
    const Scene scene = family.scene(complete(family, {{"side", side}}));
    std::vector<std::size_t> first(scene.bodies.size(), 0);
    std::size_t unknowns = 0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      first[i] = unknowns;
      if (scene.bodies[i].type == BodyType::dynamic) unknowns += 3;
    }
    std::vector<std::vector<double>> rows;
    for (const Joint& joint : scene.joints) {
      const auto& hinge = std::get<Revolute>(joint);
      std::vector<double> x(unknowns, 0);
      std::vector<double> y(unknowns, 0);
      for (const auto& [body, sign] : {std::pair{hinge.a, 1.0}, std::pair{hinge.b, -1.0}}) {
        if (scene.bodies[body].type != BodyType::dynamic) continue;
        const Vec arm{hinge.anchor.x - scene.bodies[body].position.x, hinge.anchor.y - scene.bodies[body].position.y};
        x[first[body]] = y[first[body] + 1] = sign;
        x[first[body] + 2] = -sign * arm.y;
        y[first[body] + 2] = sign * arm.x;
      }
      rows.push_back(x);
      rows.push_back(y);
    }
    EXPECT_EQ(rank(rows), unknowns) << side;
  }
}

// A net without its inner hinges falls by metres; one that sags like a rope of that width by decimetres.
TEST(JointGrid, StopsANetThatSags) {
  EXPECT_LT((Of{"joint-grid", {}, "7.4", Quantity::y}.allows_at_most()), 0.2);
  EXPECT_LT((Of{"joint-grid", {}, "7.4", Quantity::y}.allows(statement_of::accurate())), 0.001);
}

}  // namespace
}  // namespace plumb::joint_grid_test
