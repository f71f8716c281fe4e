#include "solver/island.h"

#include <algorithm>
#include <cmath>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr int most_substeps = 32;

constexpr Real fast = static_cast<Real>(0.1);  // m/s

/// Budget of one island and step: beyond, islands keep the base numbers of sub-steps and iterations.
constexpr std::size_t most_body_substeps = 4000;

/// The same where loads ask for sub-steps, in lanes: 16 for 2500 bodies, which sink by millimetres in 4. And for a step
/// that drove bodies into each other, which few do: a light body that two heavy ones squeeze out goes at 20 m/s, its
/// own size in a sub-step of 1/32 step, and turns meanwhile.
constexpr int most_substeps_again = 128;
constexpr std::size_t most_loaded_substeps = 40000;

/// The same for a blow that is solved through a whole island, with as many sweeps as it takes: in four sub-steps so
/// many over its bodies take 12 ms. A light body between heavy ones takes more than one sweep for each body.
constexpr std::size_t most_pressed_sweeps = 40000;
constexpr std::size_t most_press_sweeps = 300;

/// Sweeps that pass a blow through a whole island: one for each body, as in a column, and some more.
std::size_t sweeps_through(std::size_t bodies) { return std::max(std::size_t{60}, bodies * 5 / 4); }

constexpr std::size_t most_few = 89;
bool few(std::size_t bodies) { return bodies <= most_few; }

}  // namespace

void Island::cut(const Settings& settings, int into) {
  constexpr Real damping_ratio = 10;
  substeps = into;
  h = settings.dt / static_cast<Real>(into);
  const Real finer = static_cast<Real>(into) / static_cast<Real>(settings.substeps);
  offset_scale = 1 / (finer * finer);
  const auto at = [this](Real frequency) {
    return Softnesses{Softness::of(frequency, damping_ratio, h), Softness::of(2 * frequency, damping_ratio, h)};
  };
  column = at(1 / (8 * h));
  if (webbed) web = at(1 / (12 * h));
  if (heap) {
    offsets = OffsetRule::passive(settings.dt, damping_ratio);
  } else {
    // The layers of a pyramid, and of most piles; a column has one for each body.
    const auto count = static_cast<Real>(bodies.size());
    const Real layers = webbed ? std::sqrt(2 * count) : count;
    offsets = OffsetRule::lifting(settings.dt, layers, damping_ratio, (webbed ? web : column).movable);
  }
}

void Island::share(Real by) {
  for (ImpactRow& row : rows) {
    for (RowPoint& p : row.points) {
      p.normal_impulse *= by;
      p.tangent_impulse *= by;
    }
  }
  joints.share(by);
}

bool closed(const BodySet& bodies, std::span<const std::uint32_t> island) {
  return std::all_of(island.begin(), island.end(), [&](std::uint32_t body) { return bodies.pushable(body); });
}

bool is_heap(const StepData& data, const Island& island) {
  const bool large = is_large(island.bodies.size(), data.settings);
  if (!island.webbed || (!large && few(island))) return false;
  const auto most = [&](std::size_t tenths, auto test) {
    const auto count = std::count_if(island.contacts.begin(), island.contacts.end(), test);
    return 10 * static_cast<std::size_t>(count) >= tenths * island.contacts.size();
  };
  const auto rubs = [&](const Tie& tie) { return data.contacts[tie.contact].static_friction > 0; };
  if (!large && most(5, rubs)) return false;
  return !most(9, [](const Tie& tie) { return tie.points == 2; });
}

bool settles(const StepData& data, const Island& island) {
  const BodySet& bodies = data.bodies;
  const auto is_new = [&](const Tie& tie) { return data.contacts[tie.contact].age == 0; };
  if (island.contacts.empty() || !std::all_of(island.contacts.begin(), island.contacts.end(), is_new)) return false;
  const Real slow = 2 * length(data.settings.gravity) * data.settings.dt;
  const auto rim_speed = [&](std::uint32_t body) {
    return std::abs(bodies.velocity[body].w) * bodies.bounding_radius[body];
  };
  return std::all_of(island.contacts.begin(), island.contacts.end(), [&](const Tie& tie) {
    const Real apart = dot(data.contacts[tie.contact].normal, bodies.velocity[tie.b].v - bodies.velocity[tie.a].v);
    return std::abs(apart) + rim_speed(tie.a) + rim_speed(tie.b) <= slow;
  });
}

void Bearing::add(const ContactRow& row) {
  if (row.mass_a.m == 0 || row.mass_b.m == 0) points += row.count;
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
    lightest = std::min(lightest, row.points[i].normal_mass);
  }
}

// load / (2 m w^2), with the impulse of the whole step.
void Bearing::add_load(const ContactRow& row, bool in_web, Real offset, const Settings& settings) {
  const Real swing = Island::swing(in_web, row.mass_a.m == 0 || row.mass_b.m == 0);
  const Real n = static_cast<Real>(settings.substeps);
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
    const RowPoint& p = row.points[i];
    const Real depth = p.normal_impulse / p.normal_mass * settings.dt / (2 * swing * swing * n * n);
    deepest = std::max(deepest, depth - offset);
  }
}

bool is_large(std::size_t bodies, const Settings& settings) {
  return static_cast<std::size_t>(2 * settings.substeps) * bodies > most_body_substeps;
}

bool may_need_substeps(std::size_t bodies, const Settings& settings) {
  return static_cast<std::size_t>(2 * settings.substeps) * bodies <= most_loaded_substeps;
}

// penetration = weight / (points on the ground) * k_max / (2 w^2), k the inverse effective mass; and penetration ~ h^2.
// With w of a column: a web may penetrate (12/8)^2 times as deep until its offsets correct it, and still settles
// fastest with these.
int substeps_for(const Island& island, const Bearing& bearing, const BodySet& bodies,
                 const std::vector<Velocity>& acceleration, const Settings& settings) {
  constexpr Real heavily = static_cast<Real>(0.7);
  const int base = settings.substeps;
  Real weight = 0;
  for (const std::uint32_t body : island.bodies) {
    const Real m = bodies.inverse_mass[body].m;
    if (m > 0) weight += length(acceleration[body].v) / m;
  }
  const Real omega = Island::swing(false, false) * static_cast<Real>(base) / settings.dt;
  const Real bears = static_cast<Real>(bearing.points) * (2 * omega * omega) * tolerated_sink;
  // Powers of two: for the weight no more than 1/.7 of the tolerated penetration, as while its boxes tilt a pyramid
  // that slides goes astray at its lower corners; and for the known load of one point down to half of it. The other
  // half is for the change of that load, which is known a step late: in a step a point covers 1 - exp(-n w h / (2
  // zeta)) = 15 % of the distance to its new equilibrium, which may thus be several times as deep. Both are within the
  // limits in nearly every step: no division then.
  const bool light = bearing.points == 0 || weight <= 2 * bearing.lightest * bears;
  if (light && 2 * bearing.deepest <= tolerated_sink) return base;
  const std::size_t count = island.bodies.size();
  if (island.pile ? !may_need_substeps(count, settings) : is_large(count, settings)) return base;
  const Real weighs = light ? Real{0} : weight / (bearing.lightest * bears);
  const Real presses = bearing.deepest / tolerated_sink;
  const Real wanted = std::max(heavily * weighs, 2 * presses) * static_cast<Real>(base * base);
  int n = base;
  while (2 * n <= most_substeps && static_cast<Real>(n * n) < wanted &&
         static_cast<std::size_t>(2 * n) * count <= most_loaded_substeps) {
    n *= 2;
  }
  return n;
}

bool may_halve(std::size_t bodies, int substeps) {
  return 2 * substeps <= most_substeps_again && static_cast<std::size_t>(2 * substeps) * bodies <= most_loaded_substeps;
}

int substeps_past(const StepData& data, std::span<const std::uint32_t> island) {
  constexpr Real far_past = Real{1} / 8;
  constexpr int most = 64;
  const Settings& settings = data.settings;
  const Real rate = data.forces.passing_rate(data.bodies, island, settings.dt);
  int n = settings.substeps;
  while (2 * n <= most && rate * settings.dt > far_past * static_cast<Real>(n) &&
         static_cast<std::size_t>(2 * n) * island.size() <= most_body_substeps) {
    n *= 2;
  }
  return n;
}

int settling_sweeps_for(std::size_t bodies) {
  constexpr std::size_t least = 300;                // needed for boxes each ten times as heavy as the one below
  constexpr std::size_t most_body_sweeps = 800000;  // takes a tenth of a second, once
  // Loads spread by a contact a sweep, to and fro: through all rows of a pyramid in as many as it has bodies.
  return static_cast<int>(std::min(std::max(least, bodies), most_body_sweeps / bodies));
}

int more_sweeps_for(std::size_t bodies) {
  if (bodies == 0) return 0;
  return static_cast<int>(few(bodies) ? sweeps_through(bodies) : most_body_substeps / bodies);
}

int press_sweeps_for(std::size_t bodies) {
  if (bodies == 0) return 0;
  return static_cast<int>(std::min(most_press_sweeps, most_pressed_sweeps / bodies));
}

bool few(const Island& island) { return few(island.bodies.size()); }

bool new_or_deep(const Contact& contact) { return contact.age == 0 || is_deep(contact.points); }

bool at_speed(const ContactRow& row, const BodySet& bodies) {
  const auto& [p, q] = row.points;
  const ContactFrame frame(row, bodies.velocity[row.a], bodies.velocity[row.b]);
  return std::max(std::abs(frame.normal_velocity(p)), std::abs(frame.normal_velocity(q))) > fast;
}

bool closes(const ContactRow& row, const BodySet& bodies, const std::vector<Velocity>& acceleration, Real dt) {
  const ContactFrame frame(row, bodies.velocity[row.a], bodies.velocity[row.b]);
  const Real falls = std::min(dot(row.normal, acceleration[row.b].v - acceleration[row.a].v), Real{0}) * (dt * dt / 2);
  return std::any_of(row.points.begin(), row.points.begin() + row.count, [&](const RowPoint& p) {
    const Real v = frame.normal_velocity(p);
    return v < -fast && p.separation + v * dt + falls < 0;
  });
}

void Unpushed::note(const Island& island, const BodySet& bodies, const std::vector<Velocity>& acceleration) {
  flown_.clear();
  for (const std::uint32_t body : island.bodies) {
    Velocity v = bodies.velocity[body];
    for (int half = 0; half < 2; ++half) {
      v.v += island.h / 2 * acceleration[body].v;
      v.w += island.h / 2 * acceleration[body].w;
    }
    flown_.push_back(v);
  }
}

void Unpushed::restore(const Island& island, const std::vector<std::uint8_t>& loaded, BodySet& bodies) const {
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const std::uint32_t body = island.bodies[i];
    const InverseMass& mass = bodies.inverse_mass[body];
    if (loaded[body] == 0 && pushable(mass)) bodies.velocity[body] = flown_[i];
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
