// Discs that fall through a board of pegs, after Galton (Natural Inheritance, 1889, p. 63).

#include <cmath>
#include <stdexcept>

#include "reports/study/statistics/ensemble.h"
#include "scenarios/parts.h"
#include "scenarios/random.h"

namespace plumb::ensembles::galton {
namespace {

constexpr int rows = 12;
constexpr int discs = 31;           // at once: each has a layer of its own, so that they do not meet
constexpr double row_height = 0.9;  // m; pegs of a row are 1 m apart
constexpr double peg = 0.12;        // m, radius
constexpr double radius = 0.25;     // m
constexpr double play = 0.1;        // m, to either side of the first peg

Scene board(Random& random) {
  const Surface of = surface(0.2, 0.3);
  Scene scene{.name = "galton", .about = "Discs fall through a board of pegs.", .duration = 30};
  Body pegs{.name = "pegs", .type = BodyType::fixed};
  for (int row = 0; row < rows; ++row) {
    for (int column = -rows; column <= rows; ++column) {
      const Vec at{column + row % 2 * 0.5, -row * row_height};
      pegs.shapes.push_back({.geometry = Circle{.radius = peg, .center = at}, .surface = of});
    }
  }
  scene.bodies.push_back(pegs);
  for (int i = 0; i < discs; ++i) {
    Body one = disc("disc " + std::to_string(i + 1), {random.between(-play, play), 0.8}, radius, of);
    one.layers = std::uint32_t{1} << i;
    scene.bodies.push_back(one);
  }
  return scene;
}

// Pegs that each disc has gone to the right, less half of the rows, as it passes below the last one.
std::vector<EnsembleDraw> draws(EnsembleRun& run, std::uint64_t seed) {
  Random random(seed);
  std::vector<EnsembleDraw> found(discs);
  int left = discs;
  run.watch(board(random), [&](double, std::span<const BodyState> states) {
    for (int i = 0; i < discs; ++i) {
      const Vec at = states[static_cast<std::size_t>(i) + 1].position;
      EnsembleDraw& draw = found[static_cast<std::size_t>(i)];
      if (!draw.empty() || at.y > -(rows - 0.5) * row_height) continue;
      const double pegs = std::round(at.x + rows / 2.0) - rows / 2.0;
      draw = {pegs, pegs * pegs / (rows / 4.0)};
      --left;
    }
    return left > 0;
  });
  if (left > 0) throw std::domain_error(std::to_string(left) + " discs are still on the board after 30 s");
  return found;
}

std::vector<double> binomial() {
  std::vector<double> shares{std::pow(0.5, rows)};
  for (int k = 0; k < rows; ++k) shares.push_back(shares.back() * (rows - k) / (k + 1));
  return shares;
}

void lean(Scene& scene) {
  const double angle = 2 * degree;
  scene.gravity = {-scene.gravity.y * std::sin(angle), scene.gravity.y * std::cos(angle)};
}

// A mirrored board with mirrored starts is the same board: left is as likely as right, whatever happens at a peg. That
// the choices at two pegs are independent is an idealisation: a disc remembers some of its speed.
const Catalog<Ensemble>::Entry entry{
    {.name = "galton",
     .question = "Do discs that fall through a board of pegs go left as often as right?",
     .dt = 1.0 / 120,
     .runs = 24,
     .large = 640,
     .statistics = {{.name = "pegs to the right",
                     .resolution = 0.4,
                     .source = "board and starts are their own mirror image"},
                    {.name = "variance / binomial",
                     .low = 1,
                     .high = 1,
                     .resolution = 0.3,
                     .source = "n/4 if the choices at n pegs are independent",
                     .idealisation = true}},
     .draws = draws,
     .control = [] { return in_altered_scene("leaning", "the board leans by 2 degrees", lean); },
     .distribution = Distribution{.name = "binomial, chi-square",
                                  .offset = rows / 2.0,
                                  .shares = binomial(),
                                  .resolution = 0.05,
                                  .source = "binomial if the choices at n pegs are independent"}}};

}  // namespace
}  // namespace plumb::ensembles::galton
