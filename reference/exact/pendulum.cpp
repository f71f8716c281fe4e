#include "reference/exact/pendulum.h"

#include <array>
#include <cmath>
#include <numbers>

#include "reference/exact/closed_form.h"
#include "reference/exact/recognise.h"
#include "scenarios/scene/mass.h"

namespace plumb {
namespace {

constexpr int levels = 12;  // the mean's digits double at each: more than a double has, from any modulus short of 1

struct Elliptic {
  double sn = 0, cn = 0, dn = 0;
};

// Jacobi's functions by the arithmetic-geometric mean (Abramowitz & Stegun 16.4): down from phi_N = 2^N a_N u by
// sin(2 phi_(n-1) - phi_n) = (c_n/a_n) sin phi_n.
Elliptic jacobi(double u, double modulus, double complement) {
  std::array<double, levels + 1> a{1};
  std::array<double, levels + 1> ratio{};
  double b = complement;
  double c = modulus;
  for (std::size_t n = 1; n <= levels; ++n) {
    c = (a[n - 1] - b) / 2;
    a[n] = (a[n - 1] + b) / 2;
    b = std::sqrt(a[n - 1] * b);
    ratio[n] = c / a[n];
  }
  double phi = std::ldexp(a[levels] * u, levels);
  for (std::size_t n = levels; n > 0; --n) phi = (phi + std::asin(ratio[n] * std::sin(phi))) / 2;
  const double sn = std::sin(phi);
  const double cn = std::cos(phi);
  return {sn, cn, std::sqrt(cn * cn + complement * complement * sn * sn)};
}

}  // namespace

double agm(double a, double b) {
  for (int i = 0; i < levels; ++i) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return a;
}

Pendulum::Pendulum(double angle, double small)
    : small_(small), sine_(std::sin(angle / 2)), cosine_(std::cos(angle / 2)) {}

// K(k) = pi/(2 agm(1, k')), T = 4 K/w.
double Pendulum::period() const { return 2 * std::numbers::pi / (small_ * agm(1, cosine_)); }

// sin(angle/2) = k cd(w t) from rest; with dn^2 - k^2 cn^2 = k'^2 its derivative is angle' = -2 k k' w sn/dn.
Pendulum::State Pendulum::at(double t) const {
  const Elliptic e = jacobi(small_ * std::remainder(t, period()), std::abs(sine_), cosine_);
  // By both sine and cosine of the half angle, so that nothing is lost near upright.
  return {2 * std::atan2(sine_ * e.cn, cosine_), -2 * sine_ * cosine_ * small_ * e.sn / e.dn};
}

namespace {

struct Hinged {
  std::vector<BodyState> start;
  std::size_t body = 0;
  Vec pivot, arm;  // arm: from the pivot to the centre at the start
  double swing = 0;
  Pendulum pendulum;

  void at(double t, std::span<BodyState> out) const {
    for (std::size_t i = 0; i < start.size(); ++i) out[i] = start[i];
    const Pendulum::State now = pendulum.at(t);
    const double turn = now.angle - swing;
    const Vec here = turned(arm, turn);
    out[body].position = pivot + here;
    out[body].angle = start[body].angle + turn;
    out[body].velocity = now.speed * left_of(here);
    out[body].angular_velocity = now.speed;
  }
};

Recognised<Hinged> recognise_pendulum(const Scene& scene) {
  const std::optional<Pair> pair = one_on_ground(scene);
  if (!scene.forces.empty() || !pair || scene.joints.size() != 1) return "solves one body hinged to a fixed one";
  const Revolute* hinge = std::get_if<Revolute>(&scene.joints.front());
  if (hinge == nullptr) return "solves one body hinged to a fixed one";
  const Body& body = scene.bodies[pair->body];
  if ((body.layers & scene.bodies[pair->ground].layers) != 0) return "solves bodies that share no layer";
  if (body.linear_damping != 0 || body.angular_damping != 0) return "knows no damping";
  const BodyState start = start_of(body);
  if (start.velocity != Vec{} || start.angular_velocity != 0) return "solves a pendulum let go at rest";
  const Mass mass = mass_of(body);
  const Vec gravity = gravity_of(scene, body);
  const Vec arm = start.position - hinge->anchor;
  const double d = length(arm);
  if (mass.inertia <= 0 || length(gravity) == 0 || d == 0) return "solves a pendulum that gravity pulls back";
  const double swing = std::atan2(cross(gravity, arm), dot(gravity, arm));
  if (std::abs(swing) > std::numbers::pi - flat) return "solves a pendulum short of upright";
  const double small = std::sqrt(mass.mass * length(gravity) * d / (mass.inertia + mass.mass * d * d));
  return Hinged{start_of(scene), pair->body, hinge->anchor, arm, swing, Pendulum(swing, small)};
}

const Catalog<Engine>::Entry pendulum_entry{closed_form<Hinged>(
    {.name = "pendulum",
     .about = "A hinged body let go at rest: sin(angle/2) = k cd(w t), T = 4 K(k)/w",
     .source = "Huygens, Legendre, Jacobi; Abramowitz & Stegun 16.4 and 17.6; Landau & Lifshitz, Mechanics, par. 11"},
    recognise_pendulum)};

}  // namespace
}  // namespace plumb
