#include <algorithm>
#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

// What the two families of ladders share: a ladder that leans on a smooth wall.
namespace plumb::scenarios::leaning_ladder {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double half = 2;      // m, from the centre to either end
constexpr double belly = 0.1;   // m, from the centre to either side

Body make_ladder(double angle, double friction) {
  return {.name = "ladder",
          .position = {half * std::cos(angle), half * std::sin(angle)},
          .angle = -angle,
          .shapes = {{.geometry = Polygon{{{half, 0}, {0, belly}, {-half, 0}, {0, -belly}}},
                      .surface = surface(friction, 0)}}};
}

// m^2, the effective inertia per mass for rotation while both ends touch: I/m + l^2, l = L/2.
double gyration() {
  const Mass mass = mass_of(make_ladder(0, 0));
  return mass.inertia / mass.mass + half * half;
}

// At rest between a rough floor and a smooth wall. Both ends are sharp, so that it touches in two points of its axis.
// Angle above the horizontal, rad; duration, s.
Scene leaning(double angle, double friction, double duration) {
  Scene scene{.gravity = {0, -gravity}, .duration = duration};
  const Body wall = half_space("wall", {.normal = {1, 0}}, surface(0, 0));
  scene.bodies = {level_ground(surface(friction, 0)), wall, make_ladder(angle, friction)};
  return scene;
}

// The angle and position of the ladder at a time of at most `latest`, s, at which its top still touches the wall.
//
// From rest, a'' = -(g l (cos a - 2 mu sin a) + 2 mu l^2 sin^2 a a'^2)/(I/m + l^2 (1 - mu sin 2a)), until the top
// leaves the wall: at sin a = (2/3) sin a0 without friction, and no earlier with it. The angular acceleration of a
// ladder on a frictionless floor, p = g l cos a/(I/m + l^2), which is largest at that angle, is an upper bound, so the
// top touches the wall for at least sqrt(2 (a0 - a)/p).
// Errors grow like cosh(q t) and sinh(q t)/q, where q^2 = g l (1 + 2 mu)/(I/m + l^2 (1 - mu)) bounds the derivative of
// a'' by a. With the angular velocity at the end W <= p t:
//   start    each end is off by the gap, in opposite directions across the ladder of length 2 l: gap/l;
//   contact  it is found a lag late. The impact then has the impulses that were missing, in the same proportions: only
//            the turn until then is missing, p lag (lag + h);
//   first    the method's drift makes it half a step early or late: |drift| h W;
//   lost     first-order contacts are found once per step and let the ends move along their tangents, which loses
//            (W dt)^2/2 of the speed in each of t/dt steps;
//   second   a phase error of (q h)^2/24 q t.
// If the ladder stands, friction removes the speed gained during the lag with its reserve, p' = g l (2 mu sin a - cos
// a)/(I/m + l^2); and it may creep, as the floor's friction bears m g/(2 tan a).
std::vector<Expectation> expectations_of_leaning(double angle, double friction, double latest) {
  const bool stands = 2 * friction * std::tan(angle) >= 1;
  const double leaves = std::asin(2 * std::sin(angle) / 3);
  const double pull = gravity * half * std::cos(leaves) / gyration();
  const double at_the_wall = std::floor(60 * std::sqrt(2 * (angle - leaves) / pull)) / 60;  // s, on the grid of 1/60 s
  const double time = stands ? latest : std::min(latest, at_the_wall);
  const double q = std::sqrt(gravity * half * (1 + 2 * friction) / (gyration() - half * half * friction));
  const double fastest = pull * time;
  const double reserve = gravity * half * (2 * friction * std::sin(angle) - std::cos(angle)) / gyration();

  const auto turn = [=](const Stepping& s) {
    const double late = gravity * lag(s) / half;
    const double round = round_off(s, time, 4 * half + gravity * time * time);
    const double start = s.contact_gap() / half;
    const double creep = s.creep / (2 * std::tan(angle)) * time / half;
    if (stands) return start + late * (late / (2 * reserve) + s.h) + creep + round;
    const double lost = first_order_in_contact(s) ? (angle - leaves) * fastest * fastest * s.dt * time / 2 : 0;
    const double second = q * q * s.h * s.h / 24 * fastest * time;
    return (start + pull * lag(s) * (lag(s) + s.h) + second + round) * std::cosh(q * time) +
           std::abs(s.drift) * s.h * fastest + lost;
  };
  const auto place = [=](const Stepping& s) { return half * turn(s) + s.contact_gap(); };
  const std::string law = stands ? "stands, as tan a >= 1/(2 mu)" : "slides, as tan a < 1/(2 mu)";
  const std::string why =
      stands ? "; the gap, and a lag that friction makes up for" : "; gap and lag at the start, drift";
  std::vector<Expectation> all;
  for (const Quantity quantity : {Quantity::angle, Quantity::x, Quantity::y}) {
    const bool angular = quantity == Quantity::angle;
    all.push_back({.body = "ladder",
                   .quantity = quantity,
                   .time = time,
                   .allowed = angular ? std::function<double(const Stepping&)>(turn) : place,
                   .source = law + why + (angular ? "" : ", times l")});
  }
  return all;
}

}  // namespace
}  // namespace plumb::scenarios::leaning_ladder

namespace plumb::scenarios::ladder {
namespace {

using namespace leaning_ladder;

constexpr double duration = 1;  // s

Scene scene(const Parameters& p) {
  Scene scene = leaning(p.at("angle") * degree, p.at("friction"), duration);
  scene.name = "ladder";
  scene.about = "A ladder leans on a smooth wall.";
  return scene;
}

// If it stands, the floor carries m g and the wall m g/(2 tan a). The contacts' total impulse is the weight times the
// time, less what may be missing in a lag at the start and in the last step.
std::vector<Expectation> expectations(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  std::vector<Expectation> all = expectations_of_leaning(angle, p.at("friction"), duration);
  if (2 * p.at("friction") * std::tan(angle) < 1) return all;
  const Scene standing = scene(p);
  const double weight = mass_of(standing.bodies[2]).mass * -standing.gravity.y;
  const auto missing = [=](const Stepping& s) {
    return weight * (lag(s) + s.h) / duration + weight * s.contact_gap() / half + round_off(s, duration, weight);
  };
  all.push_back({.body = "ladder",
                 .other = "ground",
                 .quantity = Quantity::load,
                 .over = duration,
                 .expected = weight,
                 .allowed = missing,
                 .source = "m g on average; a lag at the start and the last step"});
  all.push_back({.body = "ladder",
                 .other = "wall",
                 .quantity = Quantity::load,
                 .over = duration,
                 .expected = weight / (2 * std::tan(angle)),
                 .allowed = missing,
                 .source = "m g/(2 tan a) on average; a lag at the start and the last step"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "ladder",
     .question = "Does a ladder on a smooth wall stand if and only if tan a >= 1/(2 mu)?",
     .parameters =
         {{.name = "angle", .value = 48, .min = 20, .max = 80, .unit = "deg", .about = "above the horizontal"},
          {.name = "friction", .value = 0.5, .min = 0, .max = 0.9, .about = "of ladder and floor"}},
     .variants = {{"stands", {}}, {"slides", {{"angle", 38}}}},
     .closed_form = "ladder",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::ladder

namespace plumb::scenarios::sliding_ladder {
namespace {

using namespace leaning_ladder;
constexpr double after = 0.75;  // s, when it has left the wall and not yet landed

Scene scene(const Parameters& p) {
  Scene scene = leaning(p.at("angle") * degree, 0, after);
  scene.name = "sliding-ladder";
  scene.about = "A ladder slides down a smooth wall on a smooth floor.";
  return scene;
}

// The top leaves the wall where sin a = (2/3) sin a0, with a'^2 = 2 w^2 (sin a0 - sin a), w^2 = g l/(I/m + l^2). From
// then on nothing pushes along the floor and the centre keeps the speed l sin a a'. That is the maximum of x', so
// errors in a or in time have only a second-order effect. The speed is off by the method's drift in the energy, by what
// steps along the tangent lose, (W dt)^2/2 of it in each of t/dt steps, and by a gap at the start.
// Contacts are resolved once per step: the ladder may leave a step early or late, or be pushed once more as in the step
// before. At the moment of leaving the push is zero, and it changes by 3 w^2 l cos^2 a with the angle: two steps away,
// at the angular velocity W, that is 6 w^2 l cos^2 a W dt.
std::vector<Expectation> expectations(const Parameters& p) {
  const double angle = p.at("angle") * degree;
  std::vector<Expectation> all = expectations_of_leaning(angle, 0, after);
  const double high = std::sin(angle);
  const double w = std::sqrt(gravity * half / gyration());
  const double fastest = w * std::sqrt(2 * high / 3);
  const double speed = half * fastest * 2 / 3 * high;
  const auto allowed = [=](const Stepping& s) {
    const double lost = first_order_in_contact(s) ? fastest * fastest * s.dt * after / 2 : 0;
    const double push = 6 * w * w * half * (1 - 4 * high * high / 9) * fastest * s.dt;  // m/s^2
    return push * s.dt + gravity * std::abs(s.drift) * s.h + speed * (lost + s.contact_gap() / half) +
           round_off(s, after, speed + gravity * after);
  };
  all.push_back({.body = "ladder",
                 .quantity = Quantity::vx,
                 .expected = speed,
                 .allowed = allowed,
                 .source = "leaves the wall at sin a = (2/3) sin a0 and keeps l sin a a'; a step late, drift"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "sliding-ladder",
     .question = "Does a ladder on a smooth floor leave the wall when its top has come down to two thirds of its "
                 "initial height?",
     .parameters =
         {{.name = "angle", .value = 60, .min = 50, .max = 70, .unit = "deg", .about = "above the horizontal"}},
     .variants = {{"60deg", {}}},
     .closed_form = "ladder",
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::sliding_ladder
