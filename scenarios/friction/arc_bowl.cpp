#include <cmath>
#include <numbers>
#include <string>

#include "scenarios/allowance.h"
#include "scenarios/friction/rolling_in_bowl.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::arc_bowl {
namespace {

using Bowl = RollingInBowl;

constexpr double gravity = Bowl::gravity, radius = Bowl::radius, round = Bowl::round;
constexpr double swings = Bowl::round - Bowl::radius;  // m, the radius of the circle of the disc's centre

Bowl bowl_of(const Parameters& p) {
  return {p.at("kink") * degree, -static_cast<int>(std::lround(p.at("angle") / p.at("kink")))};
}

// s, the period of a disc that rolls on a circle: 3/2 of its mass hang from a pendulum of that length, T = 2 pi sqrt(3
// (R - r)/(2 g))/agm(1, cos(a/2)) (Lamb, Dynamics; Gauss).
double period(double amplitude) {
  double a = 1;
  double b = std::cos(amplitude / 2);
  for (int i = 0; i < 8; ++i) {
    const double geometric = std::sqrt(a * b);
    a = (a + b) / 2;
    b = geometric;
  }
  return 2 * std::numbers::pi * std::sqrt(1.5 * swings / gravity) / a;
}

double amplitude(const Bowl& bowl) { return std::abs(bowl.slope(bowl.first())); }

Scene scene(const Parameters& p) {
  const Bowl shape = bowl_of(p);
  const Surface rough = surface(p.at("friction"), 0);
  Scene scene{.name = "arc-bowl",
              .about = "A disc rolls to and fro in a round bowl of many short segments.",
              .gravity = {0, -gravity},
              .duration = whole_steps(0.75 * period(amplitude(shape)))};
  Body bowl{.name = "bowl", .type = BodyType::fixed};
  const double half = round * std::tan(shape.kink() / 2);
  for (int piece = shape.first() - 2; piece <= 2 - shape.first(); ++piece) {
    const Vec n = shape.normal(piece);
    const Vec middle{-round * n.x, round - round * n.y};
    bowl.shapes.push_back({.geometry = Segment{{middle.x - half * n.y, middle.y + half * n.x},
                                               {middle.x + half * n.y, middle.y - half * n.x}},
                           .surface = rough});
  }
  scene.bodies = {bowl, disc("disc", shape.centre({shape.first()}), radius, rough)};
  return scene;
}

// Between the segments the disc loses 1 - (1 + 2 cos a)/3 of its speed at each kink a, which is counted: about s a/3 in
// all after the way s, in rad. Else it swings as a pendulum with w^2 = 2 g/(3 (R - r)), by s0, at most at W = w s0. A
// method is off by
//   drift      half a step ahead or behind: |drift| h W, a lag at the start, and what it slides until then;
//   curvature  in a step the path turns by W h/(R - r), and a third of that times half of the turn is lost of the speed
//              as at a kink, W h s/3 in all for the way s, in rad;
//   lead       forces and contact may act along the direction of up to a step early: s'' = -w^2 s(t + h), a damping of
//              w^2 h, which takes h w^2 t/2 of the swing;
//   second     (w h)^2/12 of the phase w t, and W^2 h^2/3 of the way;
//   gap        the disc rolls on a circle that is larger or smaller by that: half of gap/(R - r) of the phase, and on
//              an arm longer or shorter by it, a third of gap/r of the phase; and the gap itself;
//   ahead      it touches segments a gap away already, which are steeper by b = sqrt(2 gap/(R - r)), and loses as much
//              more as at kinks of that angle: s b/3.
std::vector<Expectation> expectations(const Parameters& p) {
  const Bowl bowl = bowl_of(p);
  const double end = scene(p).duration;
  const double angle = amplitude(bowl);
  const double s0 = swings * angle;
  const double w = std::sqrt(2.0 / 3 * gravity / swings);
  const std::string law =
      "Lamb, Dynamics: T = 2 pi sqrt(3 (R - r)/(2 g))/agm(1, cos(a/2)), less (1 + 2 cos k)/3 at each kink k";
  std::vector<Expectation> all;
  for (const int quarter : {1, 2, 3}) {
    const double t = std::floor(60 * end * quarter / 3) / 60;
    const Bowl::Rolling then = bowl.rolled({bowl.first()}, t);
    const auto off = [=](const Stepping& s) {
      const double way = quarter * angle;  // rad
      const double turned = w * angle * s.h;
      const double k = w * s.h;
      const bool first = first_order(s) || first_order_in_contact(s);
      const double start = (std::abs(s.drift) * s.h + lag(s)) * w * s0 + slid_late(s, gravity);
      const double lost = first ? turned * way / 3 * s0 + k * w * t / 2 * s0 : 0;
      const double second = (k * k / 12 * w * t + turned * turned / 3) * s0;
      const double gap = s.contact_gap() * (1 + w * t * s0 * (0.5 / swings + 1 / (3 * radius)));
      const double ahead = std::sqrt(2 * s.contact_gap() / swings) * way / 3 * s0;
      return start + lost + second + gap + ahead + s.creep / 3 * t + round_off(s, t, round * (1 + w * t));
    };
    all.push_back({.body = "disc",
                   .quantity = Quantity::x,
                   .time = t,
                   .expected = bowl.centre(then).x,
                   .allowed = off,
                   .source = law});
    all.push_back({.body = "disc",
                   .quantity = Quantity::angle,
                   .time = t,
                   .expected = -then.path / radius,
                   .allowed = [=](const Stepping& s) { return 2 * off(s) / radius; },
                   .source = law + "; it rolls all the way"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "arc-bowl",
     .question = "Does a disc roll to and fro in a round bowl with the period of the elliptic integral?",
     .parameters = {{.name = "angle", .value = 60, .min = 10, .max = 75, .unit = "deg", .about = "at the start"},
                    {.name = "kink", .value = 1, .min = 0.5, .max = 3, .unit = "deg", .about = "between two segments"},
                    {.name = "friction", .value = 2, .min = 1, .max = 5, .about = "of disc and bowl"}},
     .variants = {{"60deg", {}}, {"20deg", {{"angle", 20}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::arc_bowl
