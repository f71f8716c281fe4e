#include "solvers/island.h"

#include <algorithm>
#include <cmath>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr int most_substeps = 32;

constexpr int most_more_sweeps = 60;

/// Budget of one island and step: large piles keep the base number of sub-steps, and of sweeps.
constexpr std::size_t most_body_substeps = 4000;

}  // namespace

void Island::cut(Real dt, int into) {
  constexpr Real damping_ratio = 10;
  substeps = into;
  h = dt / static_cast<Real>(into);
  const auto at = [this](Real frequency) {
    return Softnesses{Softness::of(frequency, damping_ratio, h), Softness::of(2 * frequency, damping_ratio, h)};
  };
  column = at(1 / (8 * h));
  if (webbed) web = at(1 / (12 * h));
  // A pyramid's layers, and those of most piles; a column has one for each body.
  const auto count = static_cast<Real>(bodies.size());
  const Real layers = webbed ? std::sqrt(2 * count) : count;
  const Real wave = pi / (2 * layers);
  const Real damping = 2 * damping_ratio * (webbed ? web : column).movable.omega * wave * wave;
  constexpr Real soonest = 2;  // 1/s; 1 ... 4 are all stable in stacks of ten, 2 settles soonest
  offset_speed = std::min(soonest, damping / 4);
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
  return std::all_of(island.begin(), island.end(),
                     [&](std::uint32_t body) { return bodies.inverse_mass[body].m + bodies.inverse_mass[body].i > 0; });
}

bool settles(const StepData& data, const Island& island) {
  const BodySet& bodies = data.bodies;
  const auto is_new = [&](const Tie& tie) { return data.contacts[tie.contact].age == 0; };
  if (island.contacts.empty() || !std::all_of(island.contacts.begin(), island.contacts.end(), is_new)) return false;
  const Real slow = 2 * length(data.settings.gravity) * data.settings.dt;
  return std::all_of(island.bodies.begin(), island.bodies.end(), [&](std::uint32_t body) {
    const Velocity& v = bodies.velocity[body];
    return length(v.v) + std::abs(v.w) * bodies.reach[body] <= slow;
  });
}

void Bearing::add(const ContactRow& row) {
  if (row.mass_a.m == 0 || row.mass_b.m == 0) points += row.count;
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
    lightest = std::min(lightest, row.points[i].normal_mass);
  }
}

bool may_need_substeps(std::size_t bodies, const Settings& settings) {
  return static_cast<std::size_t>(2 * settings.substeps) * bodies <= most_body_substeps;
}

// sink = weight / (points on the ground) * k_max / (2 w^2), k the inverse effective mass; and sink ~ h^2. With w of a
// column: a web may sink (12/8)^2 times as far until its offsets lift it, and still settles soonest with these.
int substeps_for(std::span<const std::uint32_t> island, const Bearing& bearing, const BodySet& bodies,
                 const std::vector<Velocity>& acceleration, const Settings& settings) {
  const int base = settings.substeps;
  if (bearing.points == 0) return base;
  Real weight = 0;
  for (const std::uint32_t body : island) {
    const Real m = bodies.inverse_mass[body].m;
    if (m > 0) weight += length(acceleration[body].v) / m;
  }
  const Real omega = 2 * pi * static_cast<Real>(base) / (8 * settings.dt);
  const Real load = weight / bearing.lightest;
  const Real bears = static_cast<Real>(bearing.points) * (2 * omega * omega) * tolerated_sink;
  if (load < bears) return base;
  const Real wanted = static_cast<Real>(base) * std::sqrt(load / bears);
  // Powers of two, the nearest by ratio.
  int n = base;
  while (2 * n <= most_substeps && static_cast<Real>(2 * n * n) < wanted * wanted &&
         static_cast<std::size_t>(2 * n) * island.size() <= most_body_substeps) {
    n *= 2;
  }
  return n;
}

int more_sweeps_for(std::size_t bodies) {
  if (bodies == 0) return 0;
  return static_cast<int>(std::min(most_body_substeps / bodies, static_cast<std::size_t>(most_more_sweeps)));
}

bool new_or_deep(const Contact& contact) {
  constexpr Real deep = static_cast<Real>(0.005);  // m
  return contact.age == 0 || std::min(contact.points[0].separation, contact.points[1].separation) <= -deep;
}

bool at_speed(const ContactRow& row, const BodySet& bodies) {
  constexpr Real fast = static_cast<Real>(0.1);  // m/s
  const auto& [p, q] = row.points;
  const ContactFrame frame(row, bodies.velocity[row.a], bodies.velocity[row.b]);
  return std::max(std::abs(frame.normal_velocity(p)), std::abs(frame.normal_velocity(q))) > fast;
}

}  // namespace impulse::inline IMPULSE_PRECISION
