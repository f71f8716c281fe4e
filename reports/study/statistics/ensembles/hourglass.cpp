// Grains that run out through an opening in the floor (W. A. Beverloo, H. A. Leniger, J. van de Velde, Chem. Eng. Sci.
// 15, 1961).

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "reports/study/statistics/ensemble.h"
#include "reports/study/statistics/ensembles/grains.h"

namespace plumb::ensembles::hourglass {
namespace {

constexpr double narrow = 0.5;        // m, the openings: 5 and 8 grains
constexpr double wide = 0.8;          // m
constexpr double opens = 1.5;         // s, when the shutter begins to leave the opening
constexpr double widths = 2.4;        // of the opening, from wall to wall
constexpr double shutter_speed = 10;  // m/s
const Grains grains{.radius = 0.05, .spread = 0.15, .surface = surface(0.5, 0)};

// Filled to a height of so many openings.
Scene hopper(Random& random, double opening, double height) {
  constexpr double thick = 0.1;  // m, of the floor
  const double width = widths * opening;
  Scene scene{.name = "hourglass", .about = "Grains run out through an opening in the floor.", .duration = 12};
  Body walls = half_space("walls", {.normal = {1, 0}, .offset = -width / 2}, grains.surface);
  walls.shapes.push_back({.geometry = HalfSpace{.normal = {-1, 0}, .offset = -width / 2}, .surface = grains.surface});
  const double half = (width - opening) / 2;
  for (const int side : {-1, 1}) {
    const Box plank{.size = {half, thick}, .center = {side * (opening + half) / 2, -thick / 2}};
    walls.shapes.push_back({.geometry = plank, .surface = grains.surface});
  }
  // Without friction on the grains. Its left end is under the left edge of the opening when it begins to open.
  const double way = shutter_speed * opens;
  Body shutter = box("shutter", {-way / 2, -1.5 * thick}, {opening + way, thick}, surface(0, 0));
  shutter.type = BodyType::kinematic;
  shutter.velocity = {shutter_speed, 0};
  scene.bodies = {walls, shutter};
  const double filling = 0.82 / (std::numbers::pi * grains.radius * grains.radius);  // grains per m^2
  grains.pour(scene, random, width, static_cast<int>(height * opening * width * filling));
  return scene;
}

// When each grain passed the opening, up to six in ten of them.
struct Passages {
  std::vector<double> times;
  std::size_t grains = 0;

  // Grains per second while `from` to `to` of all run out.
  double flow(double from, double to) const {
    const auto index = [&](double share) { return static_cast<std::size_t>(share * static_cast<double>(grains)); };
    return static_cast<double>(index(to) - index(from)) / (times[index(to)] - times[index(from)]);
  }
};

// nullopt if they jam: an arch of grains at rest closes the opening, and none has passed for long.
std::optional<Passages> passages(EnsembleRun& run, const Scene& scene) {
  constexpr double patience = 2;     // s, in which a hundred grains would have passed
  constexpr std::size_t others = 2;  // bodies that are no grains
  Passages passed{.grains = scene.bodies.size() - others};
  std::vector<bool> out(passed.grains, false);
  bool jammed = false;
  const auto enough = [&] { return 5 * passed.times.size() > 3 * passed.grains; };
  run.watch(scene, [&](double time, std::span<const BodyState> states) {
    for (std::size_t i = 0; i < passed.grains; ++i) {
      if (out[i] || states[i + others].position.y > -0.3) continue;
      out[i] = true;
      passed.times.push_back(time);
    }
    jammed = time > patience + (passed.times.empty() ? opens : passed.times.back());
    return !enough() && !jammed;
  });
  if (jammed) return std::nullopt;
  if (!enough()) throw std::domain_error("the grains run out too slowly");
  return passed;
}

// A hopper that runs. One that jams is filled anew: openings of five grains do jam, if rarely.
struct Running {
  Passages passed;
  int jams = 0;
};

Running running(EnsembleRun& run, Random& random, double opening, double height) {
  constexpr int most = 3;  // jams
  for (int jams = 0; jams <= most; ++jams) {
    if (auto passed = passages(run, hopper(random, opening, height))) return {*std::move(passed), jams};
  }
  throw std::domain_error(fmt::format("the grains stop running out, in {} of {} fillings", most + 1, most + 1));
}

constexpr double usual_k = 1.4;
double reach(double k) { return std::log((wide / 0.1 - k) / (narrow / 0.1 - k)); }

std::vector<EnsembleDraw> draws(EnsembleRun& run, std::uint64_t seed) {
  Random random(seed);
  // Hoppers of one shape, so that what their heights change cancels; and a tall one.
  const Running slow = running(run, random, narrow, 2.8);
  const Running fast = running(run, random, wide, 2.8);
  const Running tall = running(run, random, narrow, 6);
  const double exponent = std::log(fast.passed.flow(0.1, 0.5) / slow.passed.flow(0.1, 0.5)) / reach(usual_k);
  const double jams = slow.jams + fast.jams + tall.jams;
  return {{exponent, tall.passed.flow(0.4, 0.6) / tall.passed.flow(0.1, 0.3), jams / 3}};
}

// In two dimensions W ~ (D - k d)^(3/2), d the grains' diameter: only a free fall over the opening's own width sets it,
// not the height of the grains, as a fluid's would, W ~ D sqrt(height). k is between 1 and 2 (Mankoc et al., Granular
// Matter 9, 2007); with k = 1.4 in its place, the exponent is off by the ratio of the logarithms.
const Catalog<Ensemble>::Entry entry{
    {.name = "hourglass",
     .question = "Do grains run out as Beverloo says: as the opening to the power of 3/2, and steadily?",
     .dt = 1.0 / 120,
     .runs = 20,
     .large = 400,
     .statistics = {{.name = "exponent of the flow",
                     .low = 1.5 * reach(1) / reach(usual_k),
                     .high = 1.5 * reach(2) / reach(usual_k),
                     .resolution = 0.25,
                     .source = "3/2 (Beverloo in 2D), k between 1 and 2 instead of 1.4"},
                    {.name = "flow, later / earlier",
                     .low = 0.9,
                     .high = 1.1,
                     .resolution = 0.2,
                     .source = "within a tenth: independent of the height of the grains; a fluid's: .79"},
                    {.name = "jams of a hopper",
                     .low = 0,
                     .high = 0.1,
                     .resolution = 0.15,
                     .source =
                         "at most one in ten: two hundred grains seldom build an arch over five of them, the less "
                         "the wider the opening (Janda et al., EPL 84, 2008)"}},
     .draws = draws,
     .control = [] { return *Catalog<Control>::find("intangible"); }}};

}  // namespace
}  // namespace plumb::ensembles::hourglass
