#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/integrate.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"

namespace plumb::scenarios::chain_modes {
namespace {

constexpr double gravity = 10;    // m/s^2
constexpr double length = 0.5;    // m, of each rod
constexpr std::size_t most = 10;  // beads
constexpr double step = 1e-3;     // s, of the integration

// Discs on massless rods, the last one free (Daniel Bernoulli 1733). In a small swing of frequency w bead j, counted
// from the free end, swings with the Laguerre polynomial L_j(w^2 l/g), and the hook, L_n, stays at rest: w^2 l/g is a
// zero of L_n. For two beads that is 2 -+ sqrt 2; for a heavy chain of length n l it tends to (j/2)^2/n, with j a zero
// of the Bessel function J0.
double laguerre(std::size_t order, double at) {
  double before = 0;
  double now = 1;
  for (std::size_t k = 0; k < order; ++k) {
    const auto n = static_cast<double>(k);
    const double next = ((2 * n + 1 - at) * now - n * before) / (n + 1);
    before = now;
    now = next;
  }
  return now;
}

// The zero of that index, counted from 1: all are simple, between 0 and 4 n.
double zero_of(std::size_t order, int index) {
  const double stride = 0.01;
  double low = 0;
  int passed = 0;
  while (true) {
    passed += laguerre(order, low) * laguerre(order, low + stride) <= 0;
    if (passed == index) break;
    low += stride;
  }
  double high = low + stride;
  const bool falls = laguerre(order, low) > 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    ((laguerre(order, middle) > 0) == falls ? low : high) = middle;
  }
  return low;
}

// The angles of the rods from the vertical, and their rates; the first is at the hook.
using State = std::array<double, 2 * most>;

struct Chain {
  std::size_t beads;
  double share;      // w^2 l/g
  double amplitude;  // rad, the largest angle of a rod at the start

  explicit Chain(const Parameters& p)
      : beads(static_cast<std::size_t>(p.at("beads"))),
        share(zero_of(beads, std::min(static_cast<int>(p.at("mode")), static_cast<int>(beads)))),
        amplitude(p.at("angle") * degree) {}

  double frequency() const { return std::sqrt(share * gravity / length); }

  State start() const {
    State state{};
    double largest = 0;
    for (std::size_t i = 0; i < beads; ++i) {
      state[i] = laguerre(beads - 1 - i, share) - laguerre(beads - i, share);
      largest = std::max(largest, std::abs(state[i]));
    }
    for (std::size_t i = 0; i < beads; ++i) state[i] = std::asin(std::sin(amplitude) * state[i] / largest);
    return state;
  }

  // Of bead i, counted from 1 at the hook.
  Vec place(const State& state, std::size_t i) const {
    Vec at;
    for (std::size_t k = 0; k < i; ++k) at = {at.x + length * std::sin(state[k]), at.y - length * std::cos(state[k])};
    return at;
  }

  // Lagrange's equations without approximation: rod i moves all beads below it,
  //   sum_j m_ij (cos(q_i - q_j) q_j'' + sin(q_i - q_j) q_j'^2) = -m_ii g/l sin q_i, m_ij = n - max(i, j).
  // The matrix is symmetric and positive: Gauss's elimination needs no pivots.
  State rate(const State& now) const {
    std::array<std::array<double, most>, most> a{};
    std::array<double, most> b{};
    for (std::size_t i = 0; i < beads; ++i) {
      b[i] = -static_cast<double>(beads - i) * gravity / length * std::sin(now[i]);
      for (std::size_t j = 0; j < beads; ++j) {
        const auto moved = static_cast<double>(beads - std::max(i, j));
        a[i][j] = moved * std::cos(now[i] - now[j]);
        b[i] -= moved * std::sin(now[i] - now[j]) * now[most + j] * now[most + j];
      }
    }
    for (std::size_t k = 0; k < beads; ++k) {
      for (std::size_t i = k + 1; i < beads; ++i) {
        const double factor = a[i][k] / a[k][k];
        for (std::size_t j = k; j < beads; ++j) a[i][j] -= factor * a[k][j];
        b[i] -= factor * b[k];
      }
    }
    State derivative{};
    for (std::size_t i = beads; i-- > 0;) {
      double sum = b[i];
      for (std::size_t j = i + 1; j < beads; ++j) sum -= a[i][j] * derivative[most + j];
      derivative[most + i] = sum / a[i][i];
      derivative[i] = now[most + i];
    }
    return derivative;
  }

  State at(double time) const {
    const int steps = std::max(1, static_cast<int>(std::ceil(time / step)));
    return integrated(start(), time, steps, [this](const State& y) { return rate(y); });
  }
};

std::string name_of(std::size_t i) { return "bead " + std::to_string(i); }

double duration(const Chain& chain) { return whole_steps(3 * std::numbers::pi / chain.frequency()); }

Scene scene(const Parameters& p) {
  const Chain chain(p);
  Scene scene{.name = "chain-modes",
              .about = "A chain of beads on rods is let go in the shape of one of its modes.",
              .gravity = {0, -gravity},
              .duration = duration(chain)};
  scene.bodies.push_back({.name = "hook", .type = BodyType::fixed, .layers = 0});
  const State start = chain.start();
  for (std::size_t i = 1; i <= chain.beads; ++i) {
    Body bead = disc(name_of(i), chain.place(start, i), 0.1, {});
    bead.layers = 0;
    scene.bodies.push_back(bead);
    scene.joints.push_back(Distance{
        .a = i - 1, .b = i, .anchor_a = chain.place(start, i - 1), .anchor_b = bead.position, .length = length});
  }
  return scene;
}

// Every bead swings as a mass on a spring of frequency w, by up to its own A, while a rod turns by up to W = w angle.
// With k = w h, as of the spring and of HingedRod:
//   first     half a step ahead or behind, |drift| k A; a rod is held at the velocity level and loses (W h)^2/2 of the
//             swing a step;
//   second    the phase k^2/24 w t, and (W h)^2/3 w t of the way;
//   rods      longer or shorter by the slop: slop/(2 l) w t of the phase, and slop times the sine of each rod.
std::vector<Expectation> expectations(const Parameters& p) {
  const Chain chain(p);
  const double w = chain.frequency();
  const double end = duration(chain);
  const State start = chain.start();
  std::vector<Expectation> all;
  for (const double t : {whole_steps(std::numbers::pi / (2 * w)), end}) {
    const State then = chain.at(t);
    double largest = 0;  // m, of any bead: in a chain errors of one are errors of all
    for (std::size_t i = 1; i <= chain.beads; ++i) largest = std::max(largest, std::abs(chain.place(start, i).x));
    const auto off = [=](const Stepping& s) {
      const double k = w * s.h;
      const double turned = k * chain.amplitude;
      const double lost = first_order(s) && s.h > 0 ? turned * turned / 2 * t / s.h : 0;
      const double grown = grows(s) ? std::pow(1 + k * k, t / (2 * s.h)) - 1 : 0;
      const double share = std::abs(s.drift) * k + lost + grown + (k * k / 24 + turned * turned / 3) * w * t;
      const double rods = s.joint_slop * (largest * w * t / (2 * length) +
                                          static_cast<double>(chain.beads) * std::sin(chain.amplitude));
      return largest * share + rods + round_off(s, t, static_cast<double>(chain.beads) * length * (1 + w * t));
    };
    for (const std::size_t i : {std::size_t{1}, chain.beads}) {
      if (i == 1 && chain.beads == 1) continue;
      all.push_back({.body = name_of(i),
                     .quantity = Quantity::x,
                     .time = t,
                     .expected = chain.place(then, i).x,
                     .allowed = off,
                     .source = "D. Bernoulli (1733): w^2 l/g a zero of L_n for small swings, Lagrange's equations for "
                               "these; the phase"});
    }
  }
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "chain-modes",
     .question = "Do the modes of a hanging chain swing as Bernoulli says, those of two beads with 2 -+ sqrt 2?",
     .parameters = {{.name = "beads", .value = 2, .min = 1, .max = 10, .about = "on the chain", .whole = true},
                    {.name = "mode",
                     .value = 1,
                     .min = 1,
                     .max = 5,
                     .about = "counted from the slowest; at most the number of beads",
                     .whole = true},
                    {.name = "angle",
                     .value = 6,
                     .min = 1,
                     .max = 10,
                     .unit = "deg",
                     .about = "of the steepest rod at the start"}},
     .variants = {{"two-slow", {}},
                  {"two-fast", {{"mode", 2}}},
                  {"ten-beads", {{"beads", 10}}},
                  {"five-third", {{"beads", 5}, {"mode", 3}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::chain_modes
