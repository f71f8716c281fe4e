#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/friction/rolling_in_bowl.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::bowl {
namespace {

using Bowl = RollingInBowl;

constexpr double steep = 45;    // deg, about the slope of the piece on which the disc starts
constexpr double duration = 3;  // s
constexpr double gravity = Bowl::gravity, radius = Bowl::radius, round = Bowl::round;

Bowl bowl_of(const Parameters& p) {
  return {p.at("kink") * degree, -static_cast<int>(std::lround(steep / p.at("kink")))};
}

Scene scene(const Parameters& p) {
  const Bowl shape = bowl_of(p);
  const Surface rough = surface(p.at("friction"), 0);
  Scene scene{.name = "bowl",
              .about = "A disc is let go in a bowl of flat pieces, and rolls over the kinks between them.",
              .gravity = {0, -gravity},
              .duration = duration};
  Body bowl{.name = "bowl", .type = BodyType::fixed};
  for (int piece = shape.first() - 1; piece <= 1 - shape.first(); ++piece) {
    const Vec n = shape.normal(piece);
    bowl.shapes.push_back({.geometry = HalfSpace{.normal = n, .offset = round * n.y - round}, .surface = rough});
  }
  scene.bodies = {bowl, disc("disc", shape.centre({shape.first()}), radius, rough)};
  return scene;
}

// m and m/s that a method may be off from some moment on.
struct Slip {
  double place = 0, speed = 0;
};

// On a piece, as in slope-disc: drift, a lever arm off by the gap, creep.
Slip on_piece(const Stepping& s, double pull, double t) {
  const double speed = 4.0 / 9 * std::abs(pull) * s.contact_gap() / radius * t;
  return {drifted(s, 2.0 / 3 * pull, t) + (speed + s.creep / 3) * t, speed};
}

// At a kink that is passed at v the disc is found to touch a lag late. Until then it keeps what it loses, v - v', and
// the old piece's acceleration. Where it rests deeper on one piece than on the other, by the gap at most, it
//   meets   the kink up to gap (1 + tan a/2) sooner or later;
//   falls   as much deeper: (2/3) g gap/v of speed;
//   turns   about another arm, while its spin is that of the arm before: v/3 gap/r.
// And iterations leave some of two contacts at once.
Slip at_kink(const Stepping& s, const Bowl& bowl, const Bowl::Passage& at) {
  const double v = std::abs(at.before.speed);
  const double loss = v - std::abs(at.after.speed);
  const double gap = s.contact_gap();
  const double bend = std::abs(bowl.acceleration(at.after) - bowl.acceleration(at.before));
  return {(lag(s) + std::abs(s.drift) * s.h) * loss + gap * (1 + std::tan(bowl.kink() / 2)),
          bend * lag(s) + 2.0 / 3 * gravity * gap / v + v * (gap / (3 * radius) + unsolved(s, 2))};
}

// Every error moves on as the track bends it: by the derivatives of where the disc ends by where it was.
std::vector<Expectation> expectations(const Parameters& p) {
  const Bowl bowl = bowl_of(p);
  const Bowl::Rolling start{bowl.first()};
  std::vector<Expectation> all;
  for (const double time : {duration / 2, duration}) {
    std::vector<Bowl::Passage> passed;
    const Bowl::Rolling end = bowl.rolled(start, time, &passed);
    struct Source {
      Bowl::Passage at;
      double by_place = 0, by_speed = 0;  // m of path per m and per m/s
    };
    std::vector<Source> sources;
    for (const Bowl::Passage& at : passed) {
      const auto ends = [&](double place, double speed) {
        Bowl::Rolling moved = at.after;
        moved.place += place;
        moved.speed += speed;
        moved.path += place;
        return bowl.rolled(moved, time - at.time).path;
      };
      constexpr double little = 1e-6;
      const double inwards = at.after.speed > 0 ? little : -little;
      sources.push_back({at, std::abs(ends(inwards, 0) - end.path) / little,
                         std::abs(ends(0, little) - ends(0, -little)) / (2 * little)});
    }
    const auto off = [=](const Stepping& s) {
      const double last = passed.empty() ? time : time - passed.back().time;
      double sum = on_piece(s, gravity, last).place + slid_late(s, gravity) + 2 * s.contact_gap();
      for (const Source& one : sources) {
        const double pull = gravity * std::sin(bowl.slope(one.at.before.piece));
        const Slip piece = on_piece(s, pull, one.at.took);
        const Slip kink = at_kink(s, bowl, one.at);
        sum += one.by_place * (piece.place + kink.place) + one.by_speed * (piece.speed + kink.speed) +
               round_off(s, time, round) * (1 + one.by_place + one.by_speed / time);
      }
      return sum + round_off(s, time, round);
    };
    const std::string law = "2/3 g sin a t on each piece, (1 + 2 cos a)/3 of the speed at each kink";
    const Vec centre = bowl.centre(end);
    for (const auto& [quantity, expected] : {std::pair{Quantity::x, centre.x}, std::pair{Quantity::y, centre.y}}) {
      all.push_back(
          {.body = "disc", .quantity = quantity, .time = time, .expected = expected, .allowed = off, .source = law});
    }
    all.push_back({.body = "disc",
                   .quantity = Quantity::angle,
                   .time = time,
                   .expected = -end.path / radius,
                   .allowed = [=](const Stepping& s) { return 2 * off(s) / radius; },
                   .source = law + "; it rolls all the way"});
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "bowl",
     .question = "Does a disc roll over the kinks of a bowl, and lose at each what its turned path takes?",
     .parameters = {{.name = "kink", .value = 15, .min = 10, .max = 30, .unit = "deg", .about = "between two pieces"},
                    {.name = "friction", .value = 1, .min = 0.7, .max = 5, .about = "of disc and bowl"}},
     .variants = {{"15deg", {}}, {"30deg", {{"kink", 30}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::bowl
