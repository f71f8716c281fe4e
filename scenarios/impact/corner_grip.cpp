#include <algorithm>
#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::corner_grip {
namespace {

constexpr double moment = 0.5;  // s, of the impact

// s; it ends before the next corner lands.
double duration(const Parameters& p) { return whole_steps(moment + 0.3 / p.at("speed")); }

double level(double tilt) { return std::abs(std::cos(tilt) - std::sin(tilt)) / 2; }  // m, from the corner to the centre
double below(double tilt) { return (std::cos(tilt) + std::sin(tilt)) / 2; }          // m

Scene scene(const Parameters& p) {
  const double tilt = p.at("tilt") * degree;
  const Surface rough = surface(p.at("friction"), p.at("restitution"));
  Scene scene{.name = "corner-grip",
              .about = "A tilted box that hardly slides hits rough ground with one corner, without gravity.",
              .gravity = {0, 0},
              .duration = duration(p)};
  scene.bodies.push_back(level_ground(rough));
  Body falling = box("box", {0, below(tilt) + p.at("speed") * moment}, {1, 1}, rough);
  falling.angle = tilt;
  falling.velocity = {p.at("slide"), -p.at("speed")};
  scene.bodies.push_back(falling);
  return scene;
}

// What the impact changes: m/s, m/s, rad/s.
struct Jump {
  double along = 0, up = 0, about = 0;
};

// Of a box of 1 m and 1 kg, I = 1/6, at a corner that lies c beside the centre, to its left for a tilt below 45
// degrees, and b below it. An impulse there changes the corner's velocity by
//   along   (1 + 6 b^2) Jt - 6 b c Jn
//   up      (1 + 6 c^2) Jn - 6 b c Jt
// and what grips ends with along = 0 and up = e v.
Jump jump_of(double c, double b, double along, double up) {
  const double tt = 1 + 6 * b * b;
  const double nn = 1 + 6 * c * c;
  const double nt = -6 * b * c;
  const double determinant = tt * nn - nt * nt;
  const double jt = (nn * along - nt * up) / determinant;
  const double jn = (tt * up - nt * along) / determinant;
  return {jt, jn, 6 * (b * jt - c * jn)};
}

Jump worst(const Jump& a, const Jump& b) {
  return {std::max(a.along, b.along), std::max(a.up, b.up), std::max(a.about, b.about)};
}

Jump difference(const Jump& a, const Jump& b) {
  return {std::abs(a.along - b.along), std::abs(a.up - b.up), std::abs(a.about - b.about)};
}

// If nothing slides at first, nothing does throughout, and all laws of restitution agree. A slide s in the direction in
// which the corner is thrown is turned round; Newton's law creates the energy s Jt/2 then, Poisson's gives e |knt/ktt|
// s less at the end, and Stronge's lies between: the laws allow as much of the normal velocity. An engine may find the
// impact within its skin, or late: the arm is off by that, and, as it may first turn the box to put the overlap right,
// the corner is aside by its height times 6 c/(1 + 6 c^2) of it. Iterations of friction after normal leave the share
// knt^2/(knn ktt) each. The place is off by the jump times the time by which the impact is found early or late, by what
// its error goes in the rest of the run, and by the gap that may be put right.
std::vector<Expectation> expectations(const Parameters& p) {
  const double v = p.at("speed");
  const double e = p.at("restitution");
  const double s = p.at("slide");
  const double tilt = p.at("tilt") * degree;
  const double side = std::cos(tilt) > std::sin(tilt) ? 1 : -1;  // the tilt beyond which the corner is to the right
  const double c = side * level(tilt);
  const double b = below(tilt);
  const double tt = 1 + 6 * b * b;
  const double nn = 1 + 6 * c * c;
  const double nt = 6 * b * c;
  const Jump jump = jump_of(c, b, -s, (1 + e) * v);
  const double reach = v + 4 * (std::abs(jump.along) + std::abs(jump.up) + std::abs(jump.about));
  const double end = duration(p);
  const auto exact = [=](const Stepping& st) { return round_off(st, end, reach); };
  const auto error = [=](const Stepping& st) {
    const double deep = std::max(v * lag(st), st.skin);
    const double aside = b * std::abs(6 * c / nn) * deep;
    const double unsolved = st.iterations > 0 ? (1 + e) * v * std::pow(nt * nt / (nn * tt), st.iterations) : 0;
    Jump off;
    for (const double beside : {c - aside, c, c + aside}) {
      for (const double under : {b - deep, b, b + deep}) {
        off = worst(off, difference(jump_of(beside, under, -s, (1 + e) * v), jump));
      }
    }
    for (const double law : {-1., 1.}) {
      const double up = (1 + e) * v + law * (e * std::abs(nt / tt * s) + unsolved);
      off = worst(off, difference(jump_of(c, b, -s, up), jump));
    }
    return off;
  };
  const auto along = [=](const Stepping& st) { return error(st).along + exact(st); };
  const auto up = [=](const Stepping& st) { return error(st).up + exact(st); };
  const auto about = [=](const Stepping& st) { return error(st).about + exact(st); };
  const auto place = [=](const Stepping& st) {
    return std::abs(jump.along) * found_off(st, v) + along(st) * (end - moment) + st.contact_gap();
  };
  return {{.body = "box",
           .quantity = Quantity::vx,
           .expected = s + jump.along,
           .allowed = along,
           .source = "K J = ((1+e) v, -s); arm within the skin"},
          {.body = "box",
           .quantity = Quantity::vy,
           .expected = jump.up - v,
           .allowed = up,
           .source = "K J = ((1+e) v, -s); arm within the skin"},
          {.body = "box",
           .quantity = Quantity::angular_velocity,
           .expected = jump.about,
           .allowed = about,
           .source = "r x J/I; arm within the skin"},
          {.body = "box",
           .quantity = Quantity::x,
           .expected = s * end + jump.along * (end - moment),
           .allowed = place,
           .source = "the velocity jump times the lag"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "corner-grip",
     .question = "Does a corner that grips rebound with all of its restitution, whichever way it slid a little?",
     .parameters =
         {{.name = "slide", .value = 1e-9, .min = -0.05, .max = 0.05, .unit = "m/s", .about = "along the ground"},
          {.name = "tilt", .value = 25, .min = 15, .max = 75, .unit = "deg", .about = "of the box"},
          {.name = "speed", .value = 2, .min = 2, .max = 10, .unit = "m/s", .about = "of the approach"},
          {.name = "friction", .value = 1, .min = 0.7, .max = 2, .about = "of box and ground"},
          {.name = "restitution", .value = 1, .min = 0.5, .max = 1, .about = "of box and ground"}},
     .variants = {{"back", {}}, {"forth", {{"slide", -1e-9}}}, {"e=0.8", {{"restitution", 0.8}}}},
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::corner_grip
