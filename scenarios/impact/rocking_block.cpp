#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/integrate.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::rocking_block {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double h = 4;         // m, half the block's height
constexpr double friction = 2;  // at which the corners stick
constexpr int parts = 200;      // of a swing, for quadrature and integration

// A block that rocks about its lower corners (Housner, Bull. Seism. Soc. Am. 53, 1963). On a corner it stands as a
// pendulum upside down of the length R = sqrt(b^2 + h^2), and leans by p from the vertical, p'' = w^2 sin p, w^2 = 3
// g/(4 R). Flat it leans by a = atan(b/h). With c the lean where it turns round, sin(p/2) = sin(c/2) cosh u, u' = w
// cos(p/2): for small angles p = c cosh(w t), and a quarter of a cycle takes acosh(a/c)/w.
class Block {
 public:
  explicit Block(const Parameters& p)
      : b(p.at("slenderness") * h), arm(std::hypot(b, h)), flat(std::atan2(b, h)), tilt(p.at("tilt") * flat) {}

  const double b, arm, flat;  // m, m, rad
  const double tilt;          // rad, from the ground, at the start
  double w() const { return std::sqrt(3 * gravity / (4 * arm)); }

  // About the corner that strikes, the angular momentum is kept, m (R^2/3 + h^2 - b^2) of m (R^2/3 + h^2 + b^2).
  double kept() const { return 1 - 1.5 * b * b / (arm * arm); }

  struct State {
    double tilt = 0, rate = 0;  // rad, rad/s, from the ground
    int impacts = 0;
  };

  State rocked(State now, double time) const {
    while (true) {
      const double sine = std::sin((flat - now.tilt) / 2);
      const double turn = std::sqrt(sine * sine - now.rate * now.rate / (4 * w() * w()));  // sin(c/2)
      const double since = std::copysign(takes(turn, sine), -now.rate);
      const double strikes = takes(turn, std::sin(flat / 2)) - since;
      if (strikes > time) return at(turn, since + time, now.impacts);
      time -= strikes;
      now = {0, kept() * rate_at(turn, std::sin(flat / 2)), now.impacts + 1};
    }
  }

  // rad/s, at which it strikes the ground after n impacts, and s, when.
  double strikes_at(int n) const { return std::pow(kept(), n) * rate_at(turn_of(0), std::sin(flat / 2)); }
  double strikes(int n) const { return turns(n) + takes(turn_of(n), std::sin(flat / 2)); }

  // s, when it turns round after n impacts.
  double turns(int n) const { return n == 0 ? 0 : strikes(n - 1) + takes(turn_of(n), std::sin(flat / 2)); }

 private:
  // sin(c/2) after n impacts.
  double turn_of(int n) const {
    const double sine = std::sin(flat / 2);
    if (n == 0) return std::sin((flat - tilt) / 2);
    const double rate = strikes_at(n) / (2 * w());
    return std::sqrt(sine * sine - rate * rate);
  }

  // s, from where it turns round to a lean, each by the sine of its half: the integral of du/u', by Simpson's rule.
  double takes(double turn, double sine) const {
    const double end = std::acosh(std::max(sine / turn, 1.0));
    double sum = 0;
    for (int i = 0; i <= parts; ++i) {
      const double weight = i == 0 || i == parts ? 1 : i % 2 == 1 ? 4 : 2;
      const double now = turn * std::cosh(end * i / parts);
      sum += weight / std::sqrt(1 - now * now);
    }
    return sum * end / (3 * parts * w());
  }

  double rate_at(double turn, double sine) const {
    return 2 * w() * std::sqrt(std::max(sine * sine - turn * turn, 0.0));
  }

  State at(double turn, double since, int impacts) const {
    const auto rate = [&](const std::array<double, 1>& u) {
      const double sine = turn * std::cosh(u[0]);
      return std::array<double, 1>{w() * std::sqrt(1 - sine * sine)};
    };
    const double u = integrated(std::array<double, 1>{0}, since, parts, rate)[0];
    const double sine = turn * std::cosh(u);
    return {flat - 2 * std::asin(sine), -std::copysign(rate_at(turn, sine), since), impacts};
  }
};

// Counter-clockwise on the left corner before the first impact, clockwise on the right one after it, and so on.
double side(int impacts) { return impacts % 2 == 0 ? 1 : -1; }

Vec centre(const Block& block, double tilt, int impacts) {
  const double lean = block.flat - tilt;
  return {side(impacts) * (block.arm * std::sin(lean) - block.b), block.arm * std::cos(lean)};
}

int impacts_of(const Parameters& p) { return static_cast<int>(p.at("impacts")); }

Scene scene(const Parameters& p) {
  const Block block(p);
  const Surface rough = surface(friction, 0);
  Scene scene{.name = "rocking-block",
              .about = "A block is let go on one of its lower corners, and rocks from one to the other.",
              .gravity = {0, -gravity},
              .duration = whole_steps(block.turns(impacts_of(p)))};
  Body body = box("block", centre(block, block.tilt, 0), {2 * block.b, 2 * h}, rough);
  body.angle = block.tilt;
  scene.bodies = {level_ground(rough), body};
  return scene;
}

// rad and rad/s that a method may be off from some moment on.
struct Slip {
  double tilt = 0, rate = 0;
};

// A swing up and down again, or down at the start, with at most the rate W, in that time. As a rod on a hinge
// (swing.h):
//   first     half a step ahead or behind, |drift| h W; what moves along its tangent is pushed back, and loses
//             (W h)^2/2 of the centre's share of the speed, 3/4, a step;
//   second    (w h)^2/24 of the phase, and (W h)^2/3 of the way;
//   corner    sinks in by the gap, which tilts a block of width 2 b by gap/(2 b).
Slip in_swing(const Stepping& s, const Block& block, double fastest, double time) {
  const double turned = fastest * s.h;
  const double k = block.w() * s.h;
  const bool first = first_order(s) || first_order_in_contact(s);
  const double lost = s.h > 0 && first ? 0.75 * turned * turned / 2 * time / s.h : 0;
  return {std::abs(s.drift) * turned + (k * k / 24 + turned * turned / 3) * fastest * time +
              s.contact_gap() / (2 * block.b),
          lost * fastest};
}

// An impact at the rate W is found a lag late, where the block is W lag deeper, or early or late by the gap, which
// tilts it by gap/(2 b). Off by d there, what is kept of the rate is off by 2 w^2 sin a d/W, as what falls on differs
// from what it climbs again. The arms of both corners are off by the gap: of kept = (k^2 + h^2 - b^2)/(k^2 + h^2 + b^2)
// that is at most 2 gap/R. Iterations leave some of the impulses at both corners: with their coupling, (1 - 3 s^2)/(1 +
// 3 s^2) between the normals and 3 s c/sqrt((1 + 3 s^2)(1 + 3 c^2)) between a normal and its friction, s = b/R, c =
// h/R, each iteration multiplies the error by its square.
Slip at_impact(const Stepping& s, const Block& block, double rate) {
  const double found = rate * lag(s) + s.contact_gap() / (2 * block.b);
  const double sine = 3 * block.b * block.b / (block.arm * block.arm);
  const double cosine = 3 - sine;
  const double normals = (1 - sine) / (1 + sine);
  const double coupling = std::max(normals * normals, sine * cosine / ((1 + sine) * (1 + cosine)));
  const double left = s.iterations == 0 ? 0 : std::pow(coupling, s.iterations);
  return {found, 2 * block.w() * block.w() * std::sin(block.flat) * found / rate +
                     (2 * s.contact_gap() / block.arm + left) * rate};
}

// What a method has done wrong when the block has struck n times: of each swing and each impact, with the moment from
// which on it counts. Energy is what is left of each by later impacts, I_O (W dW + w^2 sin a d).
struct Source {
  double time = 0;
  Block::State state;  // the right one, then
  double fastest = 0, takes = 0, strikes = 0;
};

std::vector<Source> sources(const Block& block, int impacts) {
  std::vector<Source> all;
  for (int n = 0; n <= impacts; ++n) {
    const double begins = n == 0 ? 0 : block.strikes(n - 1);
    const Block::State state = n == 0 ? Block::State{block.tilt} : Block::State{0, block.strikes_at(n), n};
    all.push_back(
        {begins, state, block.strikes_at(n), block.strikes(n) - begins, n == 0 ? 0 : block.strikes_at(n - 1)});
  }
  return all;
}

Slip slip_of(const Stepping& s, const Block& block, const Source& one) {
  const Slip swing = in_swing(s, block, one.fastest, one.takes);
  const Slip impact = one.strikes > 0 ? at_impact(s, block, one.strikes) : Slip{};
  return {swing.tilt + impact.tilt, swing.rate + impact.rate};
}

std::vector<Expectation> expectations(const Parameters& p) {
  const Block block(p);
  const Scene built = scene(p);
  const Mass mass = mass_of(built.bodies[1]);
  const double inertia = mass.inertia + mass.mass * block.arm * block.arm;  // kg m^2, about a corner
  const double reach = block.arm * (1 + block.w() * built.duration);
  const double pull = block.w() * block.w() * std::sin(block.flat);
  std::vector<Expectation> all;
  for (const int n : std::set{1, impacts_of(p)}) {
    const double time = std::floor(60 * block.turns(n)) / 60;
    const Block::State end = block.rocked({block.tilt}, time);
    struct Reach {
      Source source;
      double by_tilt = 0, by_rate = 0;  // rad per rad and per rad/s, at the end
    };
    std::vector<Reach> reached;
    for (const Source& one : sources(block, n)) {
      const auto tilts = [&](double tilt, double rate) {
        Block::State moved = one.state;
        moved.tilt += tilt;
        moved.rate += rate;
        return block.rocked(moved, time - one.time).tilt;
      };
      constexpr double little = 1e-6;
      reached.push_back({one, std::abs(tilts(little, 0) - end.tilt) / little,
                         one.state.rate == 0 ? 0 : std::abs(tilts(0, little) - tilts(0, -little)) / (2 * little)});
    }
    const auto off = [=](const Stepping& s) {
      double sum = round_off(s, time, 1 + reach) + slid_late(s, gravity) / block.b +
                   std::abs(s.drift) * block.w() * s.h * block.tilt;
      for (const Reach& one : reached) {
        const Slip slip = slip_of(s, block, one.source);
        sum += one.by_tilt * slip.tilt + one.by_rate * (slip.rate + round_off(s, time, reach) / time);
      }
      return sum;
    };
    const auto lost = [=](const Stepping& s) {
      double sum = 2 * mass.mass * gravity * (s.contact_gap() + round_off(s, time, reach));
      for (const Reach& one : reached) {
        const Slip slip = slip_of(s, block, one.source);
        const double later = std::pow(block.kept(), 2 * (n - one.source.state.impacts));
        sum += later * inertia * (one.source.fastest * slip.rate + pull * slip.tilt);
      }
      return sum;
    };
    const Vec place = centre(block, end.tilt, n);
    const std::string law =
        "Housner (1963): 1 - 1.5 sin^2 a of the spin at each impact, t = acosh(a/c)/w for small angles";
    all.push_back({.body = "block",
                   .quantity = Quantity::angle,
                   .time = time,
                   .expected = side(n) * end.tilt,
                   .allowed = off,
                   .source = law});
    all.push_back({.body = "block",
                   .quantity = Quantity::x,
                   .time = time,
                   .expected = place.x,
                   .allowed = [=](const Stepping& s) { return block.arm * off(s) + s.contact_gap() + s.creep * time; },
                   .source = law + "; its corners stay where they are"});
    all.push_back({.quantity = Quantity::energy,
                   .time = time,
                   .expected = mass.mass * gravity * h + inertia * std::pow(block.strikes_at(n), 2) / 2,
                   .allowed = lost,
                   .source = "(1 - 1.5 sin^2 a)^2n of the energy above that at rest, after n impacts"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "rocking-block",
     .question = "Does a rocking block keep 1 - 1.5 sin^2 a of its spin at each impact, and swing as Housner says?",
     .parameters = {{.name = "slenderness", .value = 0.2, .min = 0.1, .max = 0.4, .about = "width divided by height"},
                    {.name = "tilt",
                     .value = 0.6,
                     .min = 0.3,
                     .max = 0.9,
                     .about = "at the start, as a share of that at which the block falls over"},
                    {.name = "impacts", .value = 11, .min = 1, .max = 11, .about = "until the end", .whole = true}},
     .variants = {{"slender", {}}, {"stocky", {{"slenderness", 0.4}, {"impacts", 4}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::rocking_block
