#include <cmath>
#include <numbers>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::tautochrone {
namespace {

constexpr double gravity = 10;   // m/s^2
constexpr double radius = 0.1;   // m, of a bead
constexpr double highest = 1.1;  // rad, slope at the start of the uppermost bead
const Surface ice = surface(0, 0);

// The cycloid parametrised by its slope a, lowest at the origin: x = c (2 a + sin 2a), y = c (1 - cos 2a). Its arc
// length from there is 4 c sin a. The radius c of the rolling wheel follows from the quarter period pi sqrt(c/g).
struct Cycloid {
  double c;     // m
  double step;  // rad, from facet to facet

  explicit Cycloid(const Parameters& p)
      : c(gravity * std::pow(p.at("time") / std::numbers::pi, 2)), step(1 / p.at("facets")) {}

  Vec at(double a) const { return {c * (2 * a + std::sin(2 * a)), c * (1 - std::cos(2 * a))}; }

  // The corner of the chain where the tangents at facets i and i + 1 meet, `below` beneath the cycloid.
  Vec corner(int i, double below) const {
    const double a = i * step;
    const double b = (i + 1) * step;
    const auto offset = [&](double slope) {
      const Vec p = at(slope);
      return -p.x * std::sin(slope) + p.y * std::cos(slope) - below;
    };
    const double sine = std::sin(b - a);
    return {(offset(a) * std::cos(b) - offset(b) * std::cos(a)) / sine,
            (offset(a) * std::sin(b) - offset(b) * std::sin(a)) / sine};
  }
};

std::string name(int i) { return "bead " + std::to_string(i); }

// The facet at whose tangent point bead i starts.
int facet_of(const Parameters& p, int i) {
  return static_cast<int>(std::lround(highest * p.at("facets") * i / p.at("beads")));
}

// The centres of the beads move on the cycloid; the chain is its parallel curve, one bead radius below.
Scene scene(const Parameters& p) {
  const Cycloid cycloid(p);
  const int beads = static_cast<int>(p.at("beads"));
  Scene scene{.name = "tautochrone",
              .about = "Beads slide down a chain of segments along a cycloid.",
              .gravity = {0, -gravity},
              .duration = p.at("time")};
  Body chain{.name = "chain", .type = BodyType::fixed};
  const int last = facet_of(p, beads) + static_cast<int>(p.at("facets")) / 5;
  for (int i = -last; i < last; ++i) {
    chain.shapes.push_back(
        {.geometry = Segment{cycloid.corner(i - 1, radius), cycloid.corner(i, radius)}, .surface = ice});
  }
  scene.bodies.push_back(chain);
  for (int i = 1; i <= beads; ++i) {
    Body bead = disc(name(i), cycloid.at(facet_of(p, i) * cycloid.step), radius, ice);
    bead.layers = std::uint32_t{1} << i;
    scene.bodies.push_back(bead);
  }
  return scene;
}

// The x coordinate at the end. Along each facet a bead accelerates at g sin a; at each corner it loses the component of
// its velocity across the next facet, as e = 0.
double x_at_end(const Parameters& p, int bead) {
  const Cycloid cycloid(p);
  int i = facet_of(p, bead);
  const auto along = [&](int facet, Vec from) {  // m, to the facet's lower corner
    const Vec end = cycloid.corner(facet - 1, 0);
    return std::hypot(from.x - end.x, from.y - end.y);
  };
  double left = p.at("time");
  double v = 0;
  Vec at = cycloid.at(i * cycloid.step);
  while (true) {
    const double slope = i * cycloid.step;
    const double a = gravity * std::sin(slope);
    const double distance = along(i, at);
    const double end = std::sqrt(v * v + 2 * a * distance);  // m/s; a < 0 beyond the lowest facet, which few beads pass
    const double takes = 2 * distance / (v + end);
    if (!(takes < left)) return at.x - (v + a * left / 2) * left * std::cos(slope);
    left -= takes;
    at = cycloid.corner(i - 1, 0);
    v = end * std::cos(cycloid.step);
    --i;
  }
}

// On the cycloid itself, s = s0 cos(w t), w^2 = g/(4 c), s0 = 4 c sin(a0): all beads are at the bottom at the same
// time. A method that steps by h is off by
//   drift      half a step ahead or behind: 2 |drift| h v at the bottom, v = w s0, plus a lag at the start;
//   curvature  in a step the path turns by v h k, k = 1/(4 c cos a) its curvature, and half of that fraction of the
//              speed is lost as at a corner: dv = v (v h k)/2 for each k v dt, which shifts the end by dv cos(w t)/w,
//              in total by less than h s0^3 w/(8 (4 c cos a0)^2);
//   lead       if the path turns within a step, forces and contact act along the new direction for the whole step, up
//              to a step early: s'' = -w^2 s(t + h), a damping of w^2 h, which shifts the end by h w s0/2;
//   gap        the bead moves on a parallel curve at that distance: the period changes by the gap relative to 4 c cos
//              a0, pi/2 s0 times that, plus the gap itself.
std::vector<Expectation> expectations(const Parameters& p) {
  const Cycloid cycloid(p);
  const double time = p.at("time");
  const double w = std::numbers::pi / 2 / time;
  std::vector<Expectation> all;
  for (int i = 1; i <= static_cast<int>(p.at("beads")); ++i) {
    const double a0 = facet_of(p, i) * cycloid.step;
    const double s0 = 4 * cycloid.c * std::sin(a0);
    const double curvature_radius = 4 * cycloid.c * std::cos(a0);  // m, the smallest
    all.push_back({.body = name(i),
                   .quantity = Quantity::x,
                   .expected = x_at_end(p, i),
                   .allowed =
                       [=](const Stepping& s) {
                         const double first = 2 * std::abs(s.drift) * s.h * w * s0 + lag(s) * w * s0;
                         const double curvature = s.h * s0 * s0 * s0 * w / (8 * curvature_radius * curvature_radius);
                         const double lead = s.h * w * s0 / 2;
                         const double off = s.contact_gap() * (1 + std::numbers::pi / 2 * s0 / curvature_radius);
                         return first + curvature + lead + off + round_off(s, time, s0 * (1 + w * time));
                       },
                   .source = "at the bottom after pi sqrt(c/g), less the losses at the corners"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "tautochrone",
     .question = "Do beads released at any height reach the bottom of a cycloid at the same time?",
     .parameters = {{.name = "beads",
                     .value = 4,
                     .min = 1,
                     .max = 20,
                     .about = "number of beads, each on its own layer",
                     .whole = true},
                    {.name = "facets",
                     .value = 40,
                     .min = 20,
                     .max = 1000,
                     .unit = "1/rad",
                     .about = "of the chain, per radian of slope",
                     .whole = true},
                    {.name = "time",
                     .value = 1,
                     .min = 1,
                     .max = 5,
                     .unit = "s",
                     .about = "to the bottom, pi sqrt(c/g)",
                     .whole = true}},
     .variants = {{"four", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::tautochrone
