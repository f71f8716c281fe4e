#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::painleve_rod {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 3;  // s
const Vec size{2, 0.02};        // m

Scene scene(const Parameters& p) {
  const Surface rough = surface(p.at("friction"), 0);
  const double angle = p.at("angle") * degree;
  Scene scene{.name = "painleve-rod",
              .about = "A rod slides over rough ground with its foot in front.",
              .gravity = {0, -gravity},
              .duration = duration};
  scene.bodies.push_back(level_ground(rough));
  // The foot is in front of the centre, with its lower corner on the ground.
  const Vec centre{-size.x / 2 * std::cos(angle), size.x / 2 * std::sin(angle) + size.y / 2 * std::cos(angle)};
  Body rod = box("rod", centre, size, rough);
  rod.angle = -angle;
  rod.velocity = {p.at("speed"), 0};
  scene.bodies.push_back(rod);
  return scene;
}

// A force N at the foot accelerates it upwards by N/m (1 + 3 cos a (cos a - mu sin a)) for a thin rod. For mu > 4/3
// that is negative around tan 2a = -mu: Coulomb friction and rigidity contradict each other, and only an impulse solves
// it (Painleve; Lecornu). What holds in every case is that the numbers stay finite and that the energy never increases.
// A method's own energy error: while the rod falls at v <= V, V^2 = v0^2 + 2 g L, m g times its drift |drift| h V; and
// an impact that is detected late is corrected by lifting the rod out of the ground: m g (V lag + skin).
std::vector<Expectation> expectations(const Parameters& p) {
  const double weight = mass_of(scene(p).bodies[1]).mass * gravity;
  const double fastest = std::sqrt(p.at("speed") * p.at("speed") + 2 * gravity * size.x);
  const auto rise = [=](const Stepping& s) {
    return weight *
           (fastest * (lag(s) + std::abs(s.drift) * s.h) + s.skin + round_off(s, duration, fastest * duration));
  };
  return {{.quantity = Quantity::energy_rise,
           .relation = Relation::at_most,
           .expected = 0,
           .allowed = rise,
           .source = "no energy is supplied; drift in the fall, penetration at a late impact"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "painleve-rod",
     .question = "Does a rod stay finite and gain no energy where Coulomb friction and rigidity contradict each other?",
     .parameters = {{.name = "friction", .value = 2, .min = 1.34, .max = 10, .about = "of rod and ground"},
                    {.name = "angle",
                     .value = 58,
                     .min = 20,
                     .max = 80,
                     .unit = "deg",
                     .about = "of the rod above the horizontal"},
                    {.name = "speed", .value = 5, .min = 0.5, .max = 20, .unit = "m/s", .about = "at the start"}},
     .variants = {{"mu=2", {}}, {"mu=5", {{"friction", 5}, {"angle", 50}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::painleve_rod
