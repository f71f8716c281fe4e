#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::catenary {
namespace {

constexpr double gravity = 10;    // m/s^2
constexpr double whole = 4;       // m, of all rods
constexpr double damping = 3;     // 1/s
constexpr double duration = 20;   // s
constexpr double thickness = .1;  // m

// The discrete catenary (Jakob Bernoulli 1691): rod i of n equal ones bears the horizontal tension H, and at its ends
// (i - 1 - n/2) m g and (i - n/2) m g: the moments about an end tell tan = (i - (n + 1)/2) m g/H.
double slant(int i, int n, double tension) { return std::atan((i - (n + 1) / 2.0) / tension); }

// H/(m g), at which rods of that length span a width, by bisection: it grows with the tension.
double tension_of(int n, double rod, double span) {
  double low = -12;
  double high = 12;
  for (int k = 0; k < 80; ++k) {
    const double middle = (low + high) / 2;
    double spans = 0;
    for (int i = 1; i <= n; ++i) spans += rod * std::cos(slant(i, n, std::exp(middle)));
    (spans < span ? low : high) = middle;
  }
  return std::exp(low);
}

struct Rod {
  Vec center;
  double angle;
};

// Rods at these angles, one after another from the origin.
template <class AngleOf>
std::vector<Rod> laid(int n, double rod, AngleOf angle_of) {
  std::vector<Rod> all;
  Vec end;
  for (int i = 1; i <= n; ++i) {
    const double angle = angle_of(i);
    const Vec half{rod / 2 * std::cos(angle), rod / 2 * std::sin(angle)};
    all.push_back({{end.x + half.x, end.y + half.y}, angle});
    end = {end.x + 2 * half.x, end.y + 2 * half.y};
  }
  return all;
}

std::vector<Rod> hanging(int n, double rod, double span) {
  const double tension = tension_of(n, rod, span);
  return laid(n, rod, [&](int i) { return slant(i, n, tension); });
}

// A straight part of most of the rods and one of the others, which meet: two sides of a triangle above the span.
std::vector<Rod> folded(int n, double rod, double span) {
  const int most = static_cast<int>(n / 2.0 + 0.4 * span / rod);
  const double left = most * rod;
  const double right = (n - most) * rod;
  const double down = std::acos((span * span + left * left - right * right) / (2 * span * left));
  const double up = std::acos((span * span + right * right - left * left) / (2 * span * right));
  return laid(n, rod, [&](int i) { return i <= most ? -down : up; });
}

std::string name_of(int i) { return "rod " + std::to_string(i); }

Scene scene(const Parameters& p) {
  const int n = static_cast<int>(p.at("rods"));
  const double rod = whole / n;
  const double span = p.at("span") * whole;
  Scene scene{.name = "catenary",
              .about = "A chain of rods between two pins swings, damped, until it hangs at rest.",
              .gravity = {0, -gravity},
              .duration = duration};
  scene.bodies.push_back({.name = "left", .type = BodyType::fixed, .layers = 0});
  Vec end;
  for (const Rod& one : folded(n, rod, span)) {
    Body body = box(name_of(static_cast<int>(scene.bodies.size())), one.center, {rod, thickness}, {});
    body.angle = one.angle;
    body.layers = 0;
    body.linear_damping = body.angular_damping = damping;
    scene.bodies.push_back(body);
    scene.joints.push_back(Revolute{.a = scene.bodies.size() - 2, .b = scene.bodies.size() - 1, .anchor = end});
    end = {end.x + rod * std::cos(one.angle), end.y + rod * std::sin(one.angle)};
  }
  scene.bodies.push_back({.name = "right", .type = BodyType::fixed, .position = {span, 0}, .layers = 0});
  scene.joints.push_back(Revolute{.a = scene.bodies.size() - 2, .b = scene.bodies.size() - 1, .anchor = {span, 0}});
  return scene;
}

// A mode of frequency w decays as e^(-c t/2) while w > c/2, which all do: the slowest swings as a pendulum no longer
// than the chain, w^2 > g/4. What is left of a displacement of the chain's length is 12 c t/2 e^(-c t/2) of it for n <=
// 12 modes. At rest each of n + 1 joints may be off by the slop, in any direction: a chain that is longer or shorter
// by all of them, hung up anew.
std::vector<Expectation> expectations(const Parameters& p) {
  const int n = static_cast<int>(p.at("rods"));
  const double rod = whole / n;
  const double span = p.at("span") * whole;
  const std::vector<Rod> rests = hanging(n, rod, span);
  const double left = 12 * damping * duration / 2 * std::exp(-damping * duration / 2) * whole;
  const auto rounding = [=](const Stepping& s) { return round_off(s, duration, whole + gravity * duration); };
  const auto longer = [=](const Stepping& s, int i, auto part) {
    double off = 0;
    const double share = s.joint_slop * (n + 1) / n;
    for (const double more : {-share, share}) {
      const auto moved = static_cast<std::size_t>(i - 1);
      off = std::max(off, std::abs(part(hanging(n, rod + more, span)[moved]) - part(rests[moved])));
    }
    return off;
  };
  std::vector<Expectation> all;
  for (const int i : {1, (n + 1) / 2}) {
    const Rod& one = rests[static_cast<std::size_t>(i - 1)];
    const std::string name = name_of(i);
    all.push_back({.body = name,
                   .quantity = Quantity::angle,
                   .expected = one.angle,
                   .allowed =
                       [=](const Stepping& s) {
                         const double ends = 2 * s.joint_slop / rod;
                         return longer(s, i, [](const Rod& of) { return of.angle; }) + ends + left / rod + rounding(s);
                       },
                   .source = "tan = (i - (n + 1)/2) m g/H, the tension H; slop of the joints"});
    all.push_back({.body = name,
                   .quantity = Quantity::y,
                   .expected = one.center.y,
                   .allowed =
                       [=](const Stepping& s) {
                         return longer(s, i, [](const Rod& of) { return of.center.y; }) + s.joint_slop + left +
                                rounding(s);
                       },
                   .source = "discrete catenary; slop of the joints"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "catenary",
     .question = "Does a chain of rods between two pins come to rest as a discrete catenary?",
     .parameters = {{.name = "rods", .value = 7, .min = 5, .max = 12, .about = "of the chain", .whole = true},
                    {.name = "span", .value = 0.7, .min = 0.4, .max = 0.9, .about = "of the chain's length"}},
     .variants = {{"seven", {}},
                  {"ten-taut", {{"rods", 10}, {"span", 0.9}}},
                  {"five-slack", {{"rods", 5}, {"span", 0.4}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::catenary

namespace plumb::scenarios::pulled_chain {
namespace {

using catenary::gravity;
using catenary::thickness;
using catenary::whole;

constexpr double damping = 2;    // 1/s
constexpr double duration = 30;  // s
constexpr double near = 0.7;     // of the span at rest, from where the end starts

double spans(int n, double tension) {
  double sum = 0;
  for (int i = 1; i <= n; ++i) sum += whole / n * std::cos(catenary::slant(i, n, tension));
  return sum;
}

// The right end is a sled on a level rail that a constant force pulls outwards. Its weight and the chain's lie on the
// rail, so that the force is the chain's horizontal tension.
Scene scene(const Parameters& p) {
  const int n = static_cast<int>(p.at("rods"));
  const double rod = whole / n;
  Scene scene{.name = "pulled-chain",
              .about = "A chain hangs between a pin and a sled that a constant force pulls outwards, damped.",
              .gravity = {0, -gravity},
              .duration = duration};
  scene.bodies.push_back({.name = "left", .type = BodyType::fixed, .layers = 0});
  Vec end;
  for (const catenary::Rod& one : catenary::hanging(n, rod, near * spans(n, p.at("pull") * n))) {
    Body body = box(catenary::name_of(static_cast<int>(scene.bodies.size())), one.center, {rod, thickness}, {});
    body.angle = one.angle;
    scene.bodies.push_back(body);
    scene.joints.push_back(Revolute{.a = scene.bodies.size() - 2, .b = scene.bodies.size() - 1, .anchor = end});
    end = {end.x + rod * std::cos(one.angle), end.y + rod * std::sin(one.angle)};
  }
  const std::size_t sled = scene.bodies.size();
  const double weight = mass_of(scene.bodies[1]).mass * n * gravity;  // N, of the chain
  scene.bodies.push_back(box("sled", end, {0.3, 0.3}, {}));
  scene.bodies.push_back({.name = "rail", .type = BodyType::fixed, .position = {end.x, 0}});
  for (Body& body : scene.bodies) {
    body.layers = 0;
    if (body.type == BodyType::dynamic) body.linear_damping = body.angular_damping = damping;
  }
  scene.joints.push_back(Revolute{.a = sled - 1, .b = sled, .anchor = end});
  scene.joints.push_back(Prismatic{.a = sled + 1, .b = sled, .anchor = end});
  scene.forces.push_back(Constant{.body = sled, .force = {p.at("pull") * weight, 0}});
  return scene;
}

// The rods rest where tan = (i - (n + 1)/2) m g/H for the tension H of the pull; where their end is counts it. The
// slowest mode is the sled's: the tension grows by H/span at least for each metre, which moves no more than the whole
// chain and the sled, w^2 > pull g/(2 span) > (damping/2)^2, so that all modes decay as e^(-c t/2). Each of n + 1
// joints may be off by the slop.
std::vector<Expectation> expectations(const Parameters& p) {
  const int n = static_cast<int>(p.at("rods"));
  const double tension = p.at("pull") * n;
  const double left = 12 * damping * duration / 2 * std::exp(-damping * duration / 2) * whole;
  const auto rounding = [=](const Stepping& s) { return round_off(s, duration, whole + gravity * duration); };
  const double longest = std::sqrt(1 + std::pow((n - 1) / 2.0 / tension, 2));  // 1/cos of the steepest rod
  const auto place = [=](const Stepping& s) { return (n + 1) * longest * s.joint_slop + left + rounding(s); };
  std::vector<Expectation> all{
      {.body = "sled",
       .quantity = Quantity::x,
       .expected = spans(n, tension),
       .allowed = place,
       .source = "Jakob Bernoulli (1691): the span of a discrete catenary of that tension; slop of the joints"},
      {.body = "sled",
       .quantity = Quantity::y,
       .expected = 0,
       .allowed = place,
       .source = "its rail is level; slop of the joints"}};
  const double rod = whole / n;
  all.push_back({.body = catenary::name_of(1),
                 .quantity = Quantity::angle,
                 .expected = catenary::slant(1, n, tension),
                 .allowed = [=](const Stepping& s) { return 2 * place(s) / rod; },
                 .source = "tan = (1 - (n + 1)/2) m g/H; slop of the joints"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "pulled-chain",
     .question = "Does a chain's horizontal tension span it as the catenary says?",
     .parameters = {{.name = "rods", .value = 8, .min = 5, .max = 12, .about = "of the chain", .whole = true},
                    {.name = "pull", .value = 1, .min = 0.8, .max = 3, .about = "over the weight of the chain"}},
     .variants = {{"its-weight", {}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::pulled_chain
