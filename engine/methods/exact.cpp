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
#include "solver/lcp.h"
#include "solver/motion.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr std::size_t most_points = 24;           // of an island: each point adds four unknowns
constexpr Real watched = static_cast<Real>(.02);  // m, gap up to which a contact takes part

// Fraction of the largest speed to be stopped that pivoting treats as zero. A coupling is a sum of four products of
// three rounded factors each, and speeds are rounded once more.
constexpr double pivot_noise = std::max(8 * static_cast<double>(std::numeric_limits<Real>::epsilon()), lcp_round_off);

constexpr Real fits = 64 * std::numeric_limits<Real>::epsilon();  // m, overlap that is round-off

/// One contact point of the problem, which is solved in double whatever the engine's precision.
struct ProblemPoint {
  const ContactRow* row = nullptr;
  RowPoint* point = nullptr;
  double least = 0;     // m/s, the least separating speed required
  double friction = 0;  // coefficient in force
};

/// Solves all contacts of an island at once, as a linear complementarity problem: in the plane the friction cone is a
/// polyhedron, so Coulomb's law is represented exactly. For every point, with normal impulse n, friction t+ - t- and
/// the sliding speed g,
///
///   vn - least   >= 0   against n  >= 0      (separates, or pushes)
///   g + vt       >= 0   against t+ >= 0      (friction against the sliding,
///   g - vt       >= 0   against t- >= 0       at its full strength)
///   mu n - t+ - t- >= 0 against g  >= 0      (within the cone, or slides)
///
/// where vn and vt are the velocities after all impulses. `least` is e times the approach (Newton; at the velocities at
/// the start of the step, so that a load at rest is no impact), or -gap/dt for a point that does not touch yet: it may
/// close its gap within the step, but no more. So the velocities at the end of a step are consistent with the positions
/// there. The second-order effect of rotation, and overlap at the start, are removed by a second such problem, for
/// displacements, without friction.
///
/// Static and dynamic friction differ: the problem is solved with the static coefficient first, then again with the
/// dynamic one at the points that slide, until no more points slide.
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
  // m/s, the speed that pivoting may leave at rest. It treats a fraction of the largest speed to be stopped as zero, at
  // rest g dt. That is more than its rounding: a body of mass m that bears L times its weight gets impulses of L m g dt
  // from below and from above, and each of up to 4 n pivots may round their difference by u L m g dt; with all n = 24
  // points, 96 u L stays below that fraction up to L = 900; in float, to which impulses are rounded when applied, up to
  // L = 8. The next step closes the gap that this opens, but nothing reverses the sliding.
  static Real rounding(const Settings& settings) {
    return static_cast<Real>(pivot_noise) * length(settings.gravity) * settings.dt;
  }

  // Two steps of gravity press resting bodies together; that is no impact.
  static Real inelastic_speed(const Settings& settings) { return 2 * length(settings.gravity) * settings.dt; }

  void prepare(StepData& data);
  void find_islands(const BodySet& bodies);
  std::vector<ProblemPoint> points_of(std::size_t island);
  void solve(BodySet& bodies, std::vector<ProblemPoint>& points);
  void project(BodySet& bodies, std::vector<ProblemPoint>& points);

  std::vector<ContactRow> rows_;
  std::vector<std::array<double, 2>> least_;  // of each row
  Islands islands_;
  std::vector<std::vector<std::size_t>> island_rows_;
  std::vector<Pose> start_;
  std::vector<Real> start_angle_;
};

/// The entry of K for two points: the change of velocity at p for a unit impulse at q, each along normal or tangent.
double coupling(const ProblemPoint& p, bool tangent_p, const ProblemPoint& q, bool tangent_q) {
  const auto arm = [](const ProblemPoint& at_point, bool tangent, bool of_b) {
    const RowPoint& at = *at_point.point;
    return static_cast<double>(tangent ? (of_b ? at.dot_b : at.dot_a) : (of_b ? at.cross_b : at.cross_a));
  };
  const auto direction = [](const ProblemPoint& at_point, bool tangent) {
    return tangent ? perpendicular(at_point.row->normal) : at_point.row->normal;
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

/// Throws std::domain_error, before anything has moved, for islands that it cannot solve.
void Exact::step(StepData& data) {
  if (!data.joints.empty()) refuse("does not support joints");
  const Real dt = data.settings.dt;
  start_ = data.bodies.pose;
  start_angle_ = data.bodies.angle;
  prepare(data);
  std::vector<std::vector<ProblemPoint>> groups;
  for (std::size_t island = 0; island < islands_.size(); ++island) groups.push_back(points_of(island));
  data.integrator.begin(data.bodies, data.forces, dt);
  for (std::vector<ProblemPoint>& group : groups) solve(data.bodies, group);
  for (const ContactRow& row : rows_) store_row(row, data.contacts);
  data.integrator.finish(data.bodies, data.forces, dt);
  for (std::vector<ProblemPoint>& group : groups) project(data.bodies, group);
}

/// A fast contact with restitution that does not touch yet is left out: it hits in the next step, with its velocity
/// then.
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
  find_islands(data.bodies);
}

void Exact::find_islands(const BodySet& bodies) {
  islands_.clear(bodies.size());
  for (const ContactRow& row : rows_) {
    if (row.mass_a.m + row.mass_a.i > 0 && row.mass_b.m + row.mass_b.i > 0) islands_.connect(row.a, row.b);
  }
  islands_.number();
  island_rows_.assign(islands_.size(), {});
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const ContactRow& row = rows_[r];
    island_rows_[islands_.of(row.mass_a.m + row.mass_a.i > 0 ? row.a : row.b)].push_back(r);
  }
}

std::vector<ProblemPoint> Exact::points_of(std::size_t island) {
  std::vector<ProblemPoint> found;
  for (const std::size_t r : island_rows_[island]) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(rows_[r].count); ++i) {
      if (least_[r][i] == -std::numeric_limits<double>::infinity()) continue;
      found.push_back({&rows_[r], &rows_[r].points[i], least_[r][i], static_cast<double>(rows_[r].static_friction)});
    }
  }
  if (found.size() > most_points) {
    refuse("solves at most " + std::to_string(most_points) + " connected points, not " + std::to_string(found.size()));
  }
  return found;
}

void Exact::solve(BodySet& bodies, std::vector<ProblemPoint>& points) {
  const std::size_t n = points.size();
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
      const double nn = coupling(points[i], false, points[j], false);
      const double nt = coupling(points[i], false, points[j], true);
      const double tn = coupling(points[i], true, points[j], false);
      const double tt = coupling(points[i], true, points[j], true);
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
    const ContactRow& row = *points[i].row;
    const ContactFrame frame(row, bodies.velocity[row.a], bodies.velocity[row.b]);
    const auto vt = static_cast<double>(frame.tangent_velocity(*points[i].point));
    q[i] = static_cast<double>(frame.normal_velocity(*points[i].point)) - points[i].least;
    q[n + i] = vt;
    q[2 * n + i] = -vt;
  }
  double fastest = 0;
  for (const double speed : q) fastest = std::max(fastest, std::abs(speed));
  std::vector<double> z;
  const auto slides = [&](std::size_t i) { return z[3 * n + i] > pivot_noise * fastest; };
  for (bool more = true; more;) {
    for (std::size_t i = 0; i < n; ++i) at(3, i, 0, i) = points[i].friction;
    z = solution(m, q);
    more = false;
    for (std::size_t i = 0; i < n; ++i) {
      const auto dynamic = static_cast<double>(points[i].row->dynamic_friction);
      if (!slides(i) || points[i].friction == dynamic) continue;
      points[i].friction = dynamic;
      more = true;
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    const ContactRow& row = *points[i].row;
    RowPoint& p = *points[i].point;
    // Without this, rounding could leave a trace of friction at a point that does not push, and remove one from a
    // point that slides.
    const double cone = points[i].friction * z[i];
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

/// Applies the smallest displacement, in the metric of the masses, that removes all overlap: s + K z >= 0 against
/// z >= 0.
void Exact::project(BodySet& bodies, std::vector<ProblemPoint>& points) {
  const auto moved = [&](std::uint32_t body) {
    Motion motion;
    motion.d = bodies.pose[body].p - start_[body].p;
    motion.turn_by(bodies.angle[body] - start_angle_[body]);
    return motion;
  };
  const std::size_t n = points.size();
  std::vector<double> s;
  s.reserve(n);
  for (const ProblemPoint& at_point : points) {
    s.push_back(static_cast<double>(
        separation(*at_point.row, *at_point.point, moved(at_point.row->a), moved(at_point.row->b))));
  }
  if (std::none_of(s.begin(), s.end(), [](double gap) { return gap < -static_cast<double>(fits); })) return;
  std::vector<double> m(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m[i * n + j] = coupling(points[i], false, points[j], false);
  }
  const std::vector<double> z = solution(m, s);
  for (std::size_t i = 0; i < n; ++i) {
    const ContactRow& row = *points[i].row;
    const RowPoint& p = *points[i].point;
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
