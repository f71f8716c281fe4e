#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "contacts/contact_rows.h"
#include "core/method_list.h"
#include "islands/islands.h"
#include "methods/lcp.h"
#include "solver/motion.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr std::size_t most_points = 24;           // of an island: its problem has four unknowns for each
constexpr Real watched = static_cast<Real>(.02);  // m, gap up to which a contact takes part

// Share of the largest speed to be stopped that pivoting takes for zero. A coupling is a sum of four products of three
// rounded factors each, and speeds are rounded once more.
constexpr double pivot_noise = std::max(8 * static_cast<double>(std::numeric_limits<Real>::epsilon()), lcp_round_off);

constexpr Real fits = 64 * std::numeric_limits<Real>::epsilon();  // m, overlap that is round-off

/// One point of a row, in double: the problem is solved exactly whatever the engine's precision.
struct Place {
  const ContactRow* row = nullptr;
  RowPoint* point = nullptr;
  double least = 0;     // m/s, speed of parting asked for
  double friction = 0;  // coefficient in force
};

/// The contacts of an island at once, as the linear complementarity problem that they are: in the plane the friction
/// cone is a polyhedron, so Coulomb's law loses nothing. For every point, with normal impulse n, friction t+ - t- and
/// the sliding speed g,
///
///   vn - least   >= 0   against n  >= 0      (parts, or pushes)
///   g + vt       >= 0   against t+ >= 0      (friction against the sliding,
///   g - vt       >= 0   against t- >= 0       at its full strength)
///   mu n - t+ - t- >= 0 against g  >= 0      (within the cone, or slides)
///
/// where vn and vt are the velocities after all impulses. `least` is e times the approach (Newton; at the velocities
/// that the step begins with, so that a load at rest is no impact), or -gap/dt for a point that does not touch yet: it
/// may close its gap within the step, but no more. The velocities of the end of a step thus fit the positions there;
/// what rotation adds to second order, and overlap that was there at the start, goes by a second such problem, for
/// displacements, without friction.
///
/// Static friction differs from dynamic: solved with the static one first, then again with the dynamic one at the
/// points that slide, until no more do.
class Exact : public Solver {
 public:
  void step(StepData& data) override;
  void state(const Settings& settings, StatedErrors& errors) const override {
    const Real creep = rounding(settings);
    errors.gap = fits + creep * settings.dt;
    errors.creep = creep;
    errors.restitution_threshold = inelastic_speed(settings);
  }
  Margin margin(const Settings& settings) const override { return {watched, settings.dt}; }

 private:
  // m/s, by which pivoting leaves speeds of rest. What it takes for zero is a share of the largest speed to be stopped,
  // at rest g dt. That is more than it rounds: a body of mass m that bears L times its weight is given impulses of L m
  // g dt from below and from above, and each of up to 4 n pivots may round their difference by u L m g dt; with all n =
  // 24 points, 96 u L stays below that share up to L = 900; in float, to which impulses are rounded when they are
  // given, up to L = 8. The next step closes the gap that this opens, but nothing takes back the sliding.
  static Real rounding(const Settings& settings) {
    return static_cast<Real>(pivot_noise) * length(settings.gravity) * settings.dt;
  }

  // Two steps of gravity press resting bodies together; that is no impact.
  static Real inelastic_speed(const Settings& settings) { return 2 * length(settings.gravity) * settings.dt; }

  void prepare(StepData& data);
  void tie_islands(const BodySet& bodies);
  std::vector<Place> places(std::size_t island);
  void solve(BodySet& bodies, std::vector<Place>& places);
  void project(BodySet& bodies, std::vector<Place>& places);

  std::vector<ContactRow> rows_;
  std::vector<std::array<double, 2>> least_;  // of each row
  Islands islands_;
  std::vector<std::vector<std::size_t>> island_rows_;
  std::vector<Pose> start_;
  std::vector<Real> start_angle_;
};

/// The change of velocity that a unit impulse at one place makes at another, K; `across` chooses normal or tangent.
double coupling(const Place& p, bool tangent_p, const Place& q, bool tangent_q) {
  const auto arm = [](const Place& place, bool tangent, bool of_b) {
    const RowPoint& at = *place.point;
    return static_cast<double>(tangent ? (of_b ? at.dot_b : at.dot_a) : (of_b ? at.cross_b : at.cross_a));
  };
  const auto direction = [](const Place& place, bool tangent) {
    return tangent ? perpendicular(place.row->normal) : place.row->normal;
  };
  const Vec2 dp = direction(p, tangent_p);
  const Vec2 dq = direction(q, tangent_q);
  const double along =
      static_cast<double>(dp.x) * static_cast<double>(dq.x) + static_cast<double>(dp.y) * static_cast<double>(dq.y);
  double k = 0;
  for (const bool p_on_b : {false, true}) {
    for (const bool q_on_b : {false, true}) {
      const std::uint32_t body = p_on_b ? p.row->b : p.row->a;
      if (body != (q_on_b ? q.row->b : q.row->a)) continue;
      const InverseMass mass = p_on_b ? p.row->mass_b : p.row->mass_a;
      const double side = p_on_b == q_on_b ? 1 : -1;
      k += side * (static_cast<double>(mass.m) * along +
                   static_cast<double>(mass.i) * arm(p, tangent_p, p_on_b) * arm(q, tangent_q, q_on_b));
    }
  }
  return k;
}

[[noreturn]] void refuse(const std::string& why) {
  throw std::domain_error("the solver \"exact\" " + why + "; choose another one");
}

std::vector<double> solution(const std::vector<double>& m, const std::vector<double>& q) {
  const auto z = solve_lcp(m, q, pivot_noise);
  if (!z) refuse("found no impulses that fulfil all contacts at once (are bodies clamped between fixed ones?)");
  return *z;
}

/// What it cannot do it says before anything has moved.
void Exact::step(StepData& data) {
  if (!data.joints.empty()) refuse("knows no joints");
  const Real dt = data.settings.dt;
  start_ = data.bodies.pose;
  start_angle_ = data.bodies.angle;
  prepare(data);
  std::vector<std::vector<Place>> groups;
  for (std::size_t island = 0; island < islands_.size(); ++island) groups.push_back(places(island));
  data.integrator.begin(data.bodies, data.forces, dt);
  for (std::vector<Place>& group : groups) solve(data.bodies, group);
  for (const ContactRow& row : rows_) store_row(row, data.contacts);
  data.integrator.finish(data.bodies, data.forces, dt);
  for (std::vector<Place>& group : groups) project(data.bodies, group);
}

/// A fast contact with restitution that does not touch yet is left out: it hits in the next step, with the velocity
/// that it then has.
void Exact::prepare(StepData& data) {
  const Real dt = data.settings.dt;
  prepare_rows(data.bodies, data.contacts, rows_);
  least_.clear();
  for (ContactRow& row : rows_) {
    const ContactFrame first(row, data.bodies.velocity[row.a], data.bodies.velocity[row.b]);
    std::array<double, 2> least{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      RowPoint& p = row.points[i];
      p.normal_impulse = 0;
      p.tangent_impulse = 0;
      const Real approach = -first.normal_velocity(p);
      const bool bounces = row.restitution > 0 && approach > inelastic_speed(data.settings);
      if (bounces) {
        least[i] = p.separation > fits ? -std::numeric_limits<double>::infinity()
                                       : static_cast<double>(row.restitution) * static_cast<double>(approach);
      } else {
        least[i] = -static_cast<double>(std::max(p.separation, Real{0})) / static_cast<double>(dt);
      }
    }
    least_.push_back(least);
  }
  tie_islands(data.bodies);
}

void Exact::tie_islands(const BodySet& bodies) {
  islands_.clear(bodies.size());
  for (const ContactRow& row : rows_) {
    if (row.mass_a.m + row.mass_a.i > 0 && row.mass_b.m + row.mass_b.i > 0) islands_.tie(row.a, row.b);
  }
  islands_.number();
  island_rows_.assign(islands_.size(), {});
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const ContactRow& row = rows_[r];
    island_rows_[islands_.of(row.mass_a.m + row.mass_a.i > 0 ? row.a : row.b)].push_back(r);
  }
}

std::vector<Place> Exact::places(std::size_t island) {
  std::vector<Place> found;
  for (const std::size_t r : island_rows_[island]) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(rows_[r].count); ++i) {
      if (least_[r][i] == -std::numeric_limits<double>::infinity()) continue;
      found.push_back({&rows_[r], &rows_[r].points[i], least_[r][i], static_cast<double>(rows_[r].static_friction)});
    }
  }
  if (found.size() > most_points) {
    refuse("solves at most " + std::to_string(most_points) + " points that hang together, not " +
           std::to_string(found.size()));
  }
  return found;
}

void Exact::solve(BodySet& bodies, std::vector<Place>& places) {
  const std::size_t n = places.size();
  if (n == 0) return;
  // Unknowns in blocks: n, t+, t-, g.
  const std::size_t size = 4 * n;
  std::vector<double> m(size * size, 0);
  std::vector<double> q(size, 0);
  const auto at = [&](std::size_t block_row, std::size_t i, std::size_t block_column, std::size_t j) -> double& {
    return m[(block_row * n + i) * size + block_column * n + j];
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const double nn = coupling(places[i], false, places[j], false);
      const double nt = coupling(places[i], false, places[j], true);
      const double tn = coupling(places[i], true, places[j], false);
      const double tt = coupling(places[i], true, places[j], true);
      at(0, i, 0, j) = nn;
      at(0, i, 1, j) = nt;
      at(0, i, 2, j) = -nt;
      at(1, i, 0, j) = tn;
      at(1, i, 1, j) = tt;
      at(1, i, 2, j) = -tt;
      at(2, i, 0, j) = -tn;
      at(2, i, 1, j) = -tt;
      at(2, i, 2, j) = tt;
    }
    at(1, i, 3, i) = 1;
    at(2, i, 3, i) = 1;
    at(3, i, 1, i) = -1;
    at(3, i, 2, i) = -1;
    const ContactRow& row = *places[i].row;
    const ContactFrame frame(row, bodies.velocity[row.a], bodies.velocity[row.b]);
    const auto vt = static_cast<double>(frame.tangent_velocity(*places[i].point));
    q[i] = static_cast<double>(frame.normal_velocity(*places[i].point)) - places[i].least;
    q[n + i] = vt;
    q[2 * n + i] = -vt;
  }
  double fastest = 0;
  for (const double speed : q) fastest = std::max(fastest, std::abs(speed));
  std::vector<double> z;
  const auto slides = [&](std::size_t i) { return z[3 * n + i] > pivot_noise * fastest; };
  for (bool more = true; more;) {
    for (std::size_t i = 0; i < n; ++i) at(3, i, 0, i) = places[i].friction;
    z = solution(m, q);
    more = false;
    for (std::size_t i = 0; i < n; ++i) {
      const auto dynamic = static_cast<double>(places[i].row->dynamic_friction);
      if (!slides(i) || places[i].friction == dynamic) continue;
      places[i].friction = dynamic;
      more = true;
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    const ContactRow& row = *places[i].row;
    RowPoint& p = *places[i].point;
    // Rounding may leave a trace of friction to a point that does not push, and take one from a point that slides.
    const double cone = places[i].friction * z[i];
    const double friction = z[n + i] - z[2 * n + i];
    p.normal_impulse = static_cast<Real>(z[i]);
    p.tangent_impulse =
        static_cast<Real>(slides(i) ? std::copysign(cone, friction) : std::clamp(friction, -cone, cone));
    p.total_normal = p.normal_impulse;
    p.total_tangent = p.tangent_impulse;
    ContactFrame frame(row, bodies.velocity[row.a], bodies.velocity[row.b]);
    frame.push_normal(row, p, p.normal_impulse);
    frame.push_tangent(row, p, p.tangent_impulse);
    frame.write_back(row, bodies.velocity[row.a], bodies.velocity[row.b]);
  }
}

/// The least displacement, in the metric of the masses, after which nothing overlaps: s + K z >= 0 against z >= 0.
void Exact::project(BodySet& bodies, std::vector<Place>& places) {
  const auto moved = [&](std::uint32_t body) {
    Motion motion;
    motion.d = bodies.pose[body].p - start_[body].p;
    motion.turn_by(bodies.angle[body] - start_angle_[body]);
    return motion;
  };
  const std::size_t n = places.size();
  std::vector<double> s;
  s.reserve(n);
  for (const Place& place : places) {
    s.push_back(static_cast<double>(separation(*place.row, *place.point, moved(place.row->a), moved(place.row->b))));
  }
  if (std::none_of(s.begin(), s.end(), [](double gap) { return gap < -static_cast<double>(fits); })) return;
  std::vector<double> m(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m[i * n + j] = coupling(places[i], false, places[j], false);
  }
  const std::vector<double> z = solution(m, s);
  for (std::size_t i = 0; i < n; ++i) {
    const ContactRow& row = *places[i].row;
    const RowPoint& p = *places[i].point;
    const auto push = static_cast<Real>(z[i]);
    bodies.advance(row.a, {-push * row.mass_a.m * row.normal, -push * row.mass_a.i * p.cross_a}, 1);
    bodies.advance(row.b, {push * row.mass_b.m * row.normal, push * row.mass_b.i * p.cross_b}, 1);
  }
}

const MethodList<Solver>::Entry exact_entry{
    {"exact", "all contacts of an island at once, friction included, by pivoting; small islands without joints only",
     "D. Stewart and J. Trinkle (1996), M. Anitescu and F. Potra (1997); C. Lemke's complementary pivoting"},
    [] { return std::make_unique<Exact>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
