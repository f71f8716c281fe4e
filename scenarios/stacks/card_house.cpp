#include <cmath>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::card_house {
namespace {

constexpr double duration = 3;  // s
constexpr double length = 2;    // m, of a card
constexpr double thick = 0.1;   // m

// Two cards lean against each other at the angle a from the vertical and touch with the inner corners of their tops.
// They stand on the inner corners of their feet and carry loads on the outer corners of their tops.
struct Measures {
  explicit Measures(double a)
      : lean(a),
        center{thick / 2 * std::cos(a) + length / 2 * std::sin(a), thick / 2 * std::sin(a) + length / 2 * std::cos(a)},
        top(2 * center.y),
        bearing(thick * std::cos(a)),
        apart(2 * (length * std::sin(a) + bearing) + thick) {}

  double lean;
  Vec center;      // of a card, from the foot of the line of symmetry
  double top;      // m, height of the outer corner
  double bearing;  // m, the outer corner's distance from the line of symmetry
  double apart;    // m, from pair to pair
};

int levels_of(const Parameters& p) { return static_cast<int>(p.at("levels")); }
double floor_of(int level, const Measures& m) { return level * (m.top + thick); }
std::string label(int level, const std::string& what, int place) {
  return std::to_string(level + 1) + ": " + what + " " + std::to_string(place + 1);
}

// Level k has n - k pairs. A horizontal card reaches from the middle of each pair to the middle of the next, and
// carries one pair.
Scene scene(const Parameters& p) {
  const Measures m(p.at("lean") * degree);
  const Surface paper = surface(p.at("friction"), 0);
  const int levels = levels_of(p);
  Scene scene{.name = "card-house", .about = "Leaning pairs of cards, one storey on another.", .duration = duration};
  scene.bodies.push_back(level_ground(paper));
  for (int level = 0; level < levels; ++level) {
    const int pairs = levels - level;
    for (int i = 0; i < pairs; ++i) {
      const double x = (i - (pairs - 1) / 2.0) * m.apart;
      const double y = floor_of(level, m) + m.center.y;
      for (const double side : {-1.0, 1.0}) {
        Body card =
            box(label(level, side < 0 ? "left" : "right", i), {x + side * m.center.x, y}, {thick, length}, paper);
        card.angle = side * m.lean;
        scene.bodies.push_back(card);
      }
      if (i + 1 == pairs) continue;
      const Vec middle{x + m.apart / 2, floor_of(level + 1, m) - thick / 2};
      scene.bodies.push_back(box(label(level, "roof", i), middle, {m.apart - m.bearing / 5, thick}, paper));
    }
  }
  return scene;
}

// m, by which the storeys up to one, counted from 1, settle where contacts are springs. A card of weight W bears P; a
// roof bears the feet of one pair, so that P = W + P' + half a roof for P' in the storey above, 0 in the highest. In
// each storey its feet bear W + P, and its tops P and, against each other, (W/2 + P) tan a; as they come closer, it
// settles by tan a of that. The inverse mass at a corner is 1/m + x^2/I, x its distance from the centre across the
// push.
double settles(const Stepping& s, const Measures& m, int levels, int storeys) {
  const double card = length * thick;  // kg
  const double card_inertia = card * (length * length + thick * thick) / 12;
  const double span = m.apart - m.bearing / 5;
  const double roof = span * thick;
  const double roof_inertia = roof * (span * span + thick * thick) / 12;
  const auto inverse = [](double mass, double inertia, double x) { return 1 / mass + x * x / inertia; };
  const double foot = inverse(card, card_inertia, m.center.x);
  const double top = inverse(card, card_inertia, m.center.x - m.bearing);
  const double roof_end = inverse(roof, roof_inertia, span / 2);
  const double roof_middle = inverse(roof, roof_inertia, length * std::sin(m.lean));
  const double slope = std::tan(m.lean);
  double sum = 0;
  for (int storey = 1; storey <= storeys; ++storey) {
    const double bears = (levels - storey) * (card + roof / 2) * standard_gravity;
    const double weight = card * standard_gravity;
    sum += storey == 1 ? spring_depth(s.fixed_contact_frequency, weight + bears, foot)
                       : spring_depth(s.contact_frequency, weight + bears, foot + roof_middle);
    sum += spring_depth(s.contact_frequency, bears, top + roof_end);
    sum += slope *
           spring_depth(s.contact_frequency, (weight / 2 + bears) * slope, 2 * inverse(card, card_inertia, m.center.y));
  }
  return sum;
}

// It stands if friction >= tan a: a card of weight W that carries P on its top needs a horizontal force of (W/2 + P)
// tan a, of which its partner supplies (W/2) tan a and the roof, held by friction under P, P tan a; at its foot W + P
// balances all of it. A storey may settle by a gap under the feet and a gap under the roof; and, as the tops come a gap
// closer or the feet creep outwards, by tan a of that; friction bears tan a of gravity. Contacts that are springs
// settle by their load.
std::vector<Expectation> expectations(const Parameters& p) {
  const Measures m(p.at("lean") * degree);
  const double slope = std::tan(m.lean);
  std::vector<Expectation> all;
  for (const Body& card : scene(p).bodies) {
    if (card.type == BodyType::fixed || card.name.find("right") != std::string::npos) continue;
    const double storeys = std::ceil(card.position.y / (m.top + thick));
    all.push_back({.body = card.name,
                   .quantity = Quantity::y,
                   .expected = card.position.y,
                   .allowed =
                       [=, levels = levels_of(p), y = card.position.y](const Stepping& s) {
                         return storeys * ((2 + slope) * s.contact_gap() + slope * slope * s.creep * duration) +
                                settles(s, m, levels, static_cast<int>(storeys)) + round_off(s, duration, y);
                       },
                   .source = "equilibrium, as friction is above tan a; gaps and creep, storey by storey"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "card-house",
     .question = "Does a house of cards stand by friction alone?",
     .parameters =
         {{.name = "levels", .value = 2, .min = 1, .max = 8, .about = "number of storeys", .whole = true},
          {.name = "lean", .value = 20, .min = 5, .max = 25, .unit = "deg", .about = "of the cards from the vertical"},
          {.name = "friction", .value = 0.6, .min = 0.5, .max = 1, .about = "of cards and ground"}},
     .variants = {{"pair", {{"levels", 1}}}, {"two", {}}, {"three", {{"levels", 3}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::card_house
