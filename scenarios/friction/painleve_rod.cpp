#include <cmath>
#include <optional>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

namespace plumb::scenarios::painleve_rod {
namespace {

constexpr double gravity = 10;  // m/s^2
constexpr double duration = 3;  // s
const Vec size{2, 0.02};        // m

Scene scene(const Parameters& p) {
  const Surface rough = surface(p.at("friction"), 0);
  const double angle = p.at("angle") * degree;
  Scene scene{.name = "painleve-rod",
              .about = "A rod slides over rough ground with its foot in front.",
              .gravity = {0, -gravity},
              .duration = duration};
  scene.bodies.push_back(level_ground(rough));
  // The foot is in front of the centre, with its lower corner on the ground.
  const Vec centre{-size.x / 2 * std::cos(angle), size.x / 2 * std::sin(angle) + size.y / 2 * std::cos(angle)};
  Body rod = box("rod", centre, size, rough);
  rod.angle = -angle;
  rod.velocity = {p.at("speed"), 0};
  scene.bodies.push_back(rod);
  return scene;
}

// A force N at the foot, with friction mu N against its slide, accelerates it upwards by N (B_nn - mu |B_nt|), B the
// inverse inertia there: for a thin rod by N/m (1 + 3 cos a (cos a - mu sin a)). For mu > 4/3 that is negative around
// tan 2a = -mu: no force keeps the foot out of the ground. Coulomb friction and rigidity contradict each other, and
// only an impulse solves it (Painleve; Lecornu). The rod jams: the slide of the foot ends at once; it sticks, as |B_nt|
// < mu B_tt; and the impulse goes on until the foot no longer sinks, as nothing bounces. About the foot angular
// momentum stays, so that with the arm r from the centre the rod then turns about it at w = (r x v)/(k^2 + r^2).
struct Jam {
  Vec arm;          // m, from the centre to the foot
  double spin = 0;  // rad/s, after it
  Vec velocity;     // m/s, of the centre, after it
  Vec later;        // m/s, of the centre, a while after it

  double change(double speed) const { return std::hypot(velocity.x - speed, velocity.y); }
};

// A rod whose foot stays on the ground, and stands there or slides. With N and F, m/s^2, the ground's push and friction
// per mass of the rod, k^2 w' = r_x N - r_y F. While the foot stands, w' = g r_x/(k^2 + r^2). While it slides, F = +-
// mu N, and N is what leaves the foot no acceleration upwards.
struct Moving {
  double friction = 0;
  double gyration = 0;  // m^2, k^2
  double side = 0;      // of the friction where the foot slides; 0: it stands
  Vec arm;              // m, from the centre to the foot
  double spin = 0;      // rad/s
  double slide = 0;     // m/s, of the foot

  struct Rate {
    double spin;   // rad/s^2
    double slide;  // m/s^2
    double push;   // m/s^2
    double hold;   // m/s^2
  };

  Vec velocity() const { return {slide + spin * arm.y, -spin * arm.x}; }

  Rate rate() const {
    const double centripetal = spin * spin;
    if (side == 0) {
      const double w = gravity * arm.x / (gyration + dot(arm, arm));
      return {w, 0, gravity - w * arm.x + centripetal * arm.y, w * arm.y + centripetal * arm.x};
    }
    const double push =
        (gravity + centripetal * arm.y) / (1 + arm.x * arm.x / gyration - side * friction * arm.x * arm.y / gyration);
    const double hold = side * friction * push;
    const double w = (arm.x * push - arm.y * hold) / gyration;
    return {w, hold - w * arm.y - centripetal * arm.x, push, hold};
  }

  // By the midpoint rule. false if the foot leaves the ground or comes to stand again.
  bool advance(double dt) {
    if (const Rate now = rate(); side == 0 && std::abs(now.hold) > friction * now.push) side = now.hold > 0 ? 1 : -1;
    Moving half = *this;
    half.add(dt / 2, spin, rate());
    add(dt, half.spin, half.rate());
    return rate().push >= 0 && side * slide <= 0;
  }

 private:
  void add(double dt, double turns, const Rate& rate) {
    arm = rotated(arm, turns * dt);
    spin += dt * rate.spin;
    slide += dt * rate.slide;
  }
};

constexpr double soon = 0.05;  // s

// nullopt where it does not jam, or where the foot leaves the ground, or stands and slides in turn, until soon after.
std::optional<Jam> jam_of(const Parameters& p) {
  const Body rod = scene(p).bodies[1];
  const auto [mass, inertia, center] = mass_of(rod);
  const double mu = p.at("friction");
  const Vec r = rotated({size.x / 2, -size.y / 2}, rod.angle);
  const double nn = 1 / mass + r.x * r.x / inertia;
  const double tt = 1 / mass + r.y * r.y / inertia;
  const double nt = std::abs(r.x * r.y) / inertia;
  if (nn >= mu * nt || nt >= mu * tt) return std::nullopt;
  const double gyration = inertia / mass;
  Moving now{.friction = mu, .gyration = gyration, .arm = r};
  now.spin = r.y * p.at("speed") / (gyration + dot(r, r));
  Jam jam{.arm = r, .spin = now.spin, .velocity = now.velocity()};
  constexpr int steps = 10000;
  for (int i = 0; i < steps; ++i) {
    if (!now.advance(soon / steps)) return std::nullopt;
  }
  jam.later = now.velocity();
  return jam;
}

// What holds in every case is that the numbers stay finite and that the energy never increases. A method's own energy
// error: while the rod falls at v <= V, V^2 = v0^2 + 2 g L, m g times its drift |drift| h V; and an impact that is
// detected late is corrected by lifting the rod out of the ground: m g (V lag + skin).
std::vector<Expectation> expectations(const Parameters& p) {
  const double weight = mass_of(scene(p).bodies[1]).mass * gravity;
  const double speed = p.at("speed");
  const double fastest = std::sqrt(speed * speed + 2 * gravity * size.x);
  const auto rise = [=](const Stepping& s) {
    return weight *
           (fastest * (lag(s) + std::abs(s.drift) * s.h) + s.skin + round_off(s, duration, fastest * duration));
  };
  std::vector<Expectation> all{{.quantity = Quantity::energy_rise,
                                .relation = Relation::at_most,
                                .expected = 0,
                                .allowed = rise,
                                .source = "no energy is supplied; drift in the fall, penetration at a late impact"}};
  const std::optional<Jam> jam = jam_of(p);
  if (!jam) return all;
  // Nothing approaches, so that no method solves for the jam's time: it comes in the first step, with arms that turn by
  // w dt in it and may be off by a gap.
  const auto turned = [=, jam = *jam](const Stepping& s) {
    const double late = s.h > 0 ? s.dt : 0;
    return jam.change(speed) * (std::abs(jam.spin) * late + s.contact_gap() / std::hypot(jam.arm.x, jam.arm.y)) +
           round_off(s, soon, fastest * duration);
  };
  all.push_back(
      {.body = "rod",
       .quantity = Quantity::vx,
       .time = soon,
       .expected = jam->later.x,
       .allowed = turned,
       .source = "w = (r x v)/(k^2 + r^2): the foot jams, then stands or slides; the arms' rotation in a step"});
  return all;
}

const Catalog<Scenario>::Entry entry{
    {.name = "painleve-rod",
     .question =
         "Does a rod jam, stay finite and gain no energy where Coulomb friction and rigidity contradict each other?",
     .parameters = {{.name = "friction", .value = 2, .min = 1.34, .max = 10, .about = "of rod and ground"},
                    {.name = "angle",
                     .value = 58,
                     .min = 20,
                     .max = 80,
                     .unit = "deg",
                     .about = "of the rod above the horizontal"},
                    {.name = "speed", .value = 5, .min = 0.5, .max = 20, .unit = "m/s", .about = "at the start"}},
     .variants = {{"mu=2", {}}, {"mu=5", {{"friction", 5}, {"angle", 50}}}},
     .scene = scene,
     .expectations = expectations}};

}  // namespace
}  // namespace plumb::scenarios::painleve_rod
