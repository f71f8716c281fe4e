#include "reference/exact/oscillation.h"

#include <array>
#include <cmath>
#include <numbers>

#include "reference/exact/closed_form.h"
#include "reference/exact/recognise.h"
#include "scenarios/scene/mass.h"

namespace plumb {

// s = e^(-d t) (A cos w t + B sin w t), d = c/(2 m), w^2 = k/m - d^2, with A and B from s(0) and s'(0) = B w - d A.
Oscillator::Oscillator(double stretch, double speed, double mass, double stiffness, double damping)
    : decay_(damping / (2 * mass)),
      frequency_(std::sqrt(stiffness / mass - decay_ * decay_)),
      cosine_(stretch),
      sine_((speed + decay_ * stretch) / frequency_) {}

Oscillator::State Oscillator::at(double t) const {
  const double envelope = std::exp(-decay_ * t);
  const double c = std::cos(frequency_ * t);
  const double s = std::sin(frequency_ * t);
  const double stretch = cosine_ * c + sine_ * s;
  const double rate = frequency_ * (sine_ * c - cosine_ * s);
  return {envelope * stretch, envelope * (rate - decay_ * stretch)};
}

double Oscillator::amplitude() const { return std::hypot(cosine_, sine_); }

namespace {

struct SpringMass {
  std::vector<BodyState> start;
  std::size_t body = 0;
  Vec anchor, along;
  double length = 0;
  Oscillator oscillator;

  void at(double t, std::span<BodyState> out) const {
    write_states(start, out);
    const Oscillator::State now = oscillator.at(t);
    out[body].position = anchor + (length + now.stretch) * along;
    out[body].velocity = now.speed * along;
    out[body].angle = start[body].angle + t * start[body].angular_velocity;
  }
};

Recognised<SpringMass> recognise_spring(const Scene& scene) {
  if (!scene.joints.empty() || scene.bodies.size() != 1 || scene.forces.size() != 1)
    return "handles only one body on one spring";
  const Spring* spring = std::get_if<Spring>(&scene.forces.front());
  const Body& body = scene.bodies.front();
  if (spring == nullptr || spring->a || body.type != BodyType::dynamic)
    return "handles only a spring fixed to the world";
  if (gravity_of(scene, body) != Vec{}) return "handles only motion without gravity";
  if (body.linear_damping != 0 || body.angular_damping != 0) return "supports no damping except the spring's";
  const Mass mass = mass_of(body);
  if (mass.mass <= 0 || length(spring->anchor_b - mass.center) > geometry_tolerance)
    return "handles only a spring held at the centre of mass";
  const BodyState start = start_of(body);
  const Vec apart = start.position - spring->anchor_a;
  const double distance = length(apart);
  if (distance == 0) return "handles only a spring whose ends are apart";
  const Vec along = (1 / distance) * apart;
  if (std::abs(cross(start.velocity, along)) > geometry_tolerance) return "handles only motion along the spring";
  if (spring->damping * spring->damping >= 4 * mass.mass * spring->stiffness)
    return "handles only an underdamped spring";
  const Oscillator oscillator(distance - spring->length, dot(start.velocity, along), mass.mass, spring->stiffness,
                              spring->damping);
  if (oscillator.amplitude() >= spring->length) return "handles only a mass that never passes the anchor";
  return SpringMass{{start}, 0, spring->anchor_a, along, spring->length, oscillator};
}

const Catalog<Engine>::Entry spring_entry{
    closed_form<SpringMass>({.name = "spring",
                             .about = "A mass on a spring: e^(-d t) (A cos w t + B sin w t)",
                             .source = "Hooke (1678); Landau & Lifshitz, Mechanics, par. 21 and 25"},
                            recognise_spring)};

}  // namespace

namespace {

constexpr int levels = 12;  // of the mean; the digits double at each: enough for a double from any modulus short of 1

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

// The arithmetic-geometric mean.
double agm(double a, double b) {
  for (int i = 0; i < levels; ++i) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return a;
}

}  // namespace

Pendulum::Pendulum(double angle, double small)
    : small_(small), sine_(std::sin(angle / 2)), cosine_(std::cos(angle / 2)) {}

// K(k) = pi/(2 agm(1, k')), T = 4 K/w.
double Pendulum::period() const { return 2 * std::numbers::pi / (small_ * agm(1, cosine_)); }

// sin(angle/2) = k cd(w t) from rest; with dn^2 - k^2 cn^2 = k'^2 its derivative is angle' = -2 k k' w sn/dn.
Pendulum::State Pendulum::at(double t) const {
  const Elliptic e = jacobi(small_ * std::remainder(t, period()), std::abs(sine_), cosine_);
  // From both sine and cosine of the half angle, so that no precision is lost near upright.
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
    write_states(start, out);
    const Pendulum::State now = pendulum.at(t);
    const double turn = now.angle - swing;
    const Vec here = rotated(arm, turn);
    out[body].position = pivot + here;
    out[body].angle = start[body].angle + turn;
    out[body].velocity = now.speed * perpendicular(here);
    out[body].angular_velocity = now.speed;
  }
};

Recognised<Hinged> recognise_pendulum(const Scene& scene) {
  const std::optional<BodyOnGround> pair = single_body_on_ground(scene);
  if (!scene.forces.empty() || !pair || scene.joints.size() != 1) return "handles only one body hinged to a fixed one";
  const Revolute* hinge = std::get_if<Revolute>(&scene.joints.front());
  if (hinge == nullptr || hinge->limits || hinge->motor)
    return "handles only one body hinged to a fixed one, without limits or a motor";
  const Body& body = scene.bodies[pair->body];
  if ((body.layers & scene.bodies[pair->ground].layers) != 0) return "handles only bodies that share no layer";
  if (body.linear_damping != 0 || body.angular_damping != 0) return "does not support damping";
  const BodyState start = start_of(body);
  if (start.velocity != Vec{} || start.angular_velocity != 0) return "handles only a pendulum released at rest";
  const Mass mass = mass_of(body);
  const Vec gravity = gravity_of(scene, body);
  const Vec arm = start.position - hinge->anchor;
  const double d = length(arm);
  if (mass.inertia <= 0 || length(gravity) == 0 || d == 0) return "handles only a pendulum driven by gravity";
  const double swing = std::atan2(cross(gravity, arm), dot(gravity, arm));
  if (std::abs(swing) > std::numbers::pi - geometry_tolerance) return "handles only a pendulum short of upright";
  const double small = std::sqrt(mass.mass * length(gravity) * d / (mass.inertia + mass.mass * d * d));
  return Hinged{start_of(scene), pair->body, hinge->anchor, arm, swing, Pendulum(swing, small)};
}

const Catalog<Engine>::Entry pendulum_entry{closed_form<Hinged>(
    {.name = "pendulum",
     .about = "A hinged body released at rest: sin(angle/2) = k cd(w t), T = 4 K(k)/w",
     .source = "Huygens, Legendre, Jacobi; Abramowitz & Stegun 16.4 and 17.6; Landau & Lifshitz, Mechanics, par. 11"},
    recognise_pendulum)};

}  // namespace

}  // namespace plumb
