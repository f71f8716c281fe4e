#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::bowl {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double radius = 0.5;  // m, of the disc
constexpr double round = 3;     // m, from the bowl's centre to each of its flat pieces
constexpr double steep = 45;    // deg, about the slope of the piece on which the disc starts
constexpr double duration = 3;  // s

// A bowl of flat pieces, each turned from the last by the angle a of a kink. The disc's centre moves on pieces too.
class Bowl {
 public:
  explicit Bowl(const Parameters& p)
      : kink_(p.at("kink") * degree),
        half_((round - radius) * std::tan(kink_ / 2)),
        first_(-static_cast<int>(std::lround(steep / p.at("kink")))) {}

  double kink() const { return kink_; }
  int first() const { return first_; }
  double slope(int piece) const { return piece * kink_; }
  Vec normal(int piece) const { return {-std::sin(slope(piece)), std::cos(slope(piece))}; }

  // About the contact with the next piece the disc keeps its angular momentum: (3/2) v' = (1/2 + cos a) v.
  double kept() const { return (1 + 2 * std::cos(kink_)) / 3; }

  struct Rolling {
    int piece = 0;
    double place = 0;  // m, along the piece, from its middle
    double speed = 0;  // m/s
    double path = 0;   // m, rolled so far, to the right
  };
  double acceleration(const Rolling& now) const { return -2.0 / 3 * gravity * std::sin(slope(now.piece)); }

  Vec centre(const Rolling& now) const {
    const Vec n = normal(now.piece);
    return {-(round - radius) * n.x + now.place * n.y, round - (round - radius) * n.y - now.place * n.x};
  }

  // A passage over a kink, and what comes before.
  struct Passage {
    double time = 0;  // s
    double took = 0;  // s, on the piece before it
    Rolling before, after;
  };

  // After that time; kinks on the way are added to `passed`.
  Rolling rolled(Rolling now, double time, std::vector<Passage>* passed = nullptr) const {
    double gone = 0;
    while (true) {
      const double right = reaches(now, half_);
      const double left = reaches(now, -half_);
      const double next = std::min(right, left);
      if (gone + next >= time) return moved(now, time - gone);
      const Rolling before = moved(now, next);
      gone += next;
      const int way = right < left ? 1 : -1;
      now = {before.piece + way, -way * half_, kept() * before.speed, before.path};
      if (passed != nullptr) passed->push_back({gone, next, before, now});
    }
  }

 private:
  Rolling moved(Rolling now, double t) const {
    const double a = acceleration(now);
    const double way = now.speed * t + a * t * t / 2;
    return {now.piece, now.place + way, now.speed + a * t, now.path + way};
  }

  // s, until it is there, from somewhere else; infinite if it never is.
  double reaches(const Rolling& now, double end) const {
    constexpr double somewhere_else = 1e-9;
    const double a = acceleration(now) / 2;
    const double c = now.place - end;
    const double root = std::sqrt(now.speed * now.speed - 4 * a * c);  // NaN if never
    double soonest = std::numeric_limits<double>::infinity();
    for (const double sign : {-1.0, 1.0}) {
      const double t = a == 0 ? -c / now.speed : (-now.speed + sign * root) / (2 * a);
      if (t > somewhere_else) soonest = std::min(soonest, t);
    }
    return soonest;
  }

  double kink_;
  double half_;  // m, half the length of a piece on which the centre moves
  int first_;
};

Scene scene(const Parameters& p) {
  const Bowl shape(p);
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
  const Bowl bowl(p);
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
