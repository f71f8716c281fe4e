#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <functional>
#include <string>

#include "scenarios/random.h"
#include "scenarios/scene/scene.h"
#include "scenarios/scene/scene_json.h"

namespace plumb {

/// Random choices of a scene's parts. Uses only operations that round alike everywhere (no library sine or power), so
/// the same seed gives the same scene to the bit. At most one draw may stand among the arguments of a call: C++ leaves
/// their order open (in braces it does not).
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed), two_frictions_(chance(0.05)) {}

  bool chance(double share) { return random_.between(0, 1) < share; }
  /// Uniform, rounded to 1e-4, which a reader can read.
  double between(double low, double high);
  /// Every factor of two between low and high is as likely; rounded to 4 digits.
  double over_magnitudes(double low, double high);
  /// A whole number in low ... high.
  int whole(int low, int high);
  /// Many small numbers, few large ones: like over_magnitudes.
  int count(int low, int high);
  template <class Choices>
  const auto& one_of(const Choices& choices) {
    return choices[static_cast<std::size_t>(random_.next() % std::size(choices))];
  }

  /// A unit vector at a uniform angle, to within the rounding of a rational parametrisation of the circle.
  Vec direction();
  Vec within(double x, double y) { return {between(-x, x), between(-y, y)}; }

  /// Often smooth, perfectly rough, inelastic or elastic: the values at which laws change. Slides with less friction
  /// than it sticks in one scene of twenty alone, as most engines know one coefficient.
  Surface surface();
  /// A shape with mass around the origin of the body's frame, none of it further away than `size`, m.
  Geometry geometry(double size);
  /// A dynamic body of one shape, often turned.
  Body body(std::string name, Vec position, double size);
  /// 10 m/s^2 downwards, now and then tilted, weaker or absent.
  Vec gravity();
  /// To and fro or up and down, starting at rest, as what is joined to the body does.
  Path path();

 private:
  Random random_;
  bool two_frictions_;
};

/// The unit vector at a fraction of a turn, 0 ... 1, in rising order of the angle; rational, so exact to round-off.
Vec unit_at(double turn);

/// How many bodies a scene may have at most.
inline constexpr int most_bodies = 200;

/// Adds a body unless its bounding circle, `apart` m larger, meets that of a body that is there (half-spaces do not
/// count). Returns whether it did.
bool add_apart(Scene&, Body, double apart = 0.01);

/// Adds up to `count` bodies apart from all that are there. `body` draws one of a name, at most twenty times as often.
template <class Drawn>
void scatter(Scene& scene, int count, const Drawn& body) {
  for (int i = 0, tries = 0; i < count && tries < 20 * count; ++tries) {
    if (add_apart(scene, body(fmt::format("body {}", i + 1)))) ++i;
  }
}

/// A kind of random scenes. Joins Catalog<Kind> from its own file in reports/find/kinds/.
struct Kind {
  std::string name;
  std::string about;  // one line
  Posed posed = Posed::well;
  std::function<Scene(Draw&)> scene;  // its name and about are filled in by `drawn`
};

/// The n-th scene of a kind, n from 0, named "KIND/n": the same on every machine and whatever else is drawn.
Scene drawn(const Kind&, std::uint64_t seed, int n);

/// The scene of such a name. Throws std::invalid_argument for any other.
Scene drawn(const std::string& name, std::uint64_t seed);

/// Throws std::invalid_argument with the nearest name if there is no such kind.
const Kind& find_kind(const std::string& name);

}  // namespace plumb
