#include "solver/impacts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr Real never = std::numeric_limits<Real>::infinity();

/// Points closer than this (m) at an impact are solved together: a box that lands flat must not start to spin.
constexpr Real together = static_cast<Real>(0.0005);

/// The ballistic motion of the bodies.
struct Flight {
  const BodySet& bodies;
  const std::vector<Motion>& motion;
  const std::vector<Velocity>& acceleration;
  Real slow;  // m/s, approaches below are left to the contact solve

  Motion motion_at(std::uint32_t body, Real t) const {
    const Velocity& v = bodies.velocity[body];
    const Velocity& a = acceleration[body];
    Motion at = motion[body];
    if (t == 0) return at;
    at.d += t * v.v + (t * t / 2) * a.v;
    at.turn_by(t * v.w + (t * t / 2) * a.w);
    return at;
  }
  Velocity velocity_at(std::uint32_t body, Real t) const {
    const Velocity& v = bodies.velocity[body];
    const Velocity& a = acceleration[body];
    return {v.v + t * a.v, v.w + t * a.w};
  }
};

/// r x n of an arm that has rotated with its body (a disc's rim does not).
Real turned_cross(Real cross, Real turn, const Motion& body) { return cross + body.drop * cross - body.sine * turn; }
/// r . n of the same.
Real turned_dot(Real dot, Real cross, Real turn, const Motion& body) {
  return dot + body.drop * turn + body.sine * cross;
}

struct Approach {
  Real separation = 0;
  Real speed = 0;  // d separation / dt
};

/// The two bodies of a row at a later time, with the normal of that time: a face's turns with its body, and that of
/// rounded shapes follows their cores.
struct Encounter {
  const ImpactRow& row;
  Motion a, b;
  Velocity va, vb;
  Vec2 normal;
  Rotation turned;  // the normal's, since the start of the sub-step

  Encounter(const ImpactRow& seen, const Flight& flight, Real t)
      : row(seen),
        a(flight.motion_at(seen.a, t)),
        b(flight.motion_at(seen.b, t)),
        va(flight.velocity_at(seen.a, t)),
        vb(flight.velocity_at(seen.b, t)),
        normal(seen.normal) {
    if (!row.turns) return;
    if (row.normal_of == NormalOf::between) {
      const RowPoint& p = row.points[0];
      if (rim_a(p) + rim_b(p) == 0) return;  // corners that slide past each other have no normal of their own
      const Vec2 cores =
          in_frame(centres()) + rotation(b) * Vec2{p.turn_b, -p.cross_b} - rotation(a) * Vec2{p.turn_a, -p.cross_a};
      const Real distance = length(cores);
      if (distance > 0) turned = {cores.x / distance, cores.y / distance};
    } else {
      const bool of_a = row.normal_of == NormalOf::a;
      turned = rotation(flight.motion[of_a ? row.a : row.b]).inverse() * rotation(of_a ? a : b);
    }
    normal = turned * row.normal;
  }

  /// m, by which the shapes are rounded.
  static Real rim_a(const RowPoint& p) { return p.dot_a - p.turn_a; }
  static Real rim_b(const RowPoint& p) { return p.turn_b - p.dot_b; }

  Approach of(const RowPoint& p) const {
    const RowPoint q = moved(p);
    return {q.separation, dot(normal, vb.v - va.v) + vb.w * q.cross_b - va.w * q.cross_a};
  }

  /// The row at that time.
  ImpactRow moved() const {
    ImpactRow now = row;
    now.normal = normal;
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      now.points[i] = moved(row.points[i]);
    }
    return now;
  }

 private:
  /// m, from a to b.
  Vec2 centres() const { return row.between + (b.d - a.d); }
  Vec2 in_frame(Vec2 v) const { return {dot(row.normal, v), dot(perpendicular(row.normal), v)}; }

  RowPoint moved(const RowPoint& p) const {
    RowPoint q = p;
    q.separation = separation(row, p, a, b);
    q.cross_a = turned_cross(p.cross_a, p.turn_a, a);
    q.cross_b = turned_cross(p.cross_b, p.turn_b, b);
    q.dot_a = turned_dot(p.dot_a, p.cross_a, p.turn_a, a);
    q.dot_b = turned_dot(p.dot_b, p.cross_b, p.turn_b, b);
    if (!row.turns) return q;
    // In the frame of the turned normal, which a rim follows too.
    const auto apart = [&](Vec2 along) { return dot(along, centres()) + q.dot_b - q.dot_a; };
    const auto turn = [&](Real& cross, Real& dot, Real rim) {
      const Vec2 arm = turned.inverse() * Vec2{dot - rim, -cross};
      cross = -arm.y;
      dot = arm.x + rim;
    };
    const Real straight = apart(row.normal);
    turn(q.cross_a, q.dot_a, rim_a(p));
    turn(q.cross_b, q.dot_b, -rim_b(p));
    q.separation += apart(normal) - straight;
    join(q);
    return q;
  }

  /// Lets both arms end in one place: an impulse that acts on two bodies in two places would change their angular
  /// momentum. The surfaces may have slid past each other since the contact was found: a point stays where it is on the
  /// body that touches the other's face, and two corners meet midway.
  void join(RowPoint& q) const {
    const Real of_a = row.normal_of == NormalOf::a ? Real{1} : row.normal_of == NormalOf::b ? Real{0} : Real{1} / 2;
    const Real slid = dot(perpendicular(normal), centres()) - q.cross_b + q.cross_a;
    q.cross_a -= of_a * slid;
    q.cross_b += (1 - of_a) * slid;
    const Real gap = dot(normal, centres()) + q.dot_b - q.dot_a;
    q.dot_a += gap / 2;
    q.dot_b -= gap / 2;
  }
};

/// d2 separation / dt2: the accelerations along the normal, the centripetal terms of the arms, and if the normal turns
/// at w, the tangential velocity times 2 w.
Real curvature(const Encounter& now, const RowPoint& p, const Flight& flight) {
  const ImpactRow& row = now.row;
  const Velocity& a = flight.bodies.velocity[row.a];
  const Velocity& b = flight.bodies.velocity[row.b];
  Real c = dot(now.normal, flight.acceleration[row.b].v - flight.acceleration[row.a].v);
  c += a.w * a.w * p.turn_a - b.w * b.w * p.turn_b;
  if (!row.turns) return c;
  const Real s = separation(row, p, now.a, now.b);
  const Vec2 t = perpendicular(now.normal);
  if (row.normal_of == NormalOf::between) {
    const Real cores = s + Encounter::rim_a(p) + Encounter::rim_b(p);
    const Real across = dot(t, b.v - a.v) + b.w * p.turn_b - a.w * p.turn_a;
    return cores > 0 ? c + across * across / cores : c;
  }
  const Real w = row.normal_of == NormalOf::a ? a.w : b.w;
  const Real along = dot(t, b.v - a.v) + b.w * p.dot_b - a.w * p.dot_a;
  return c + w * (2 * along - w * s);
}

/// Time and speed at which a point hits.
struct Hit {
  Real time = never;
  Real speed = 0;
};

/// The first time from now on, `rest` seconds at most, at which the point touches while approaching faster than the
/// threshold.
///
/// s(now + x) = s + v x + c x^2/2 gives the initial guess; Newton's iteration on the exact path refines it (quadratic:
/// from a guess accurate to 1e-3, three iterations are below round-off).
Hit first_hit(const Encounter& here, const RowPoint& p, const Flight& flight, Real now, Real rest) {
  const Approach start = here.of(p);
  if (start.separation <= 0) return start.speed < -flight.slow ? Hit{now, -start.speed} : Hit{};

  const Real c = curvature(here, p, flight);
  const Real discriminant = start.speed * start.speed - 2 * c * start.separation;
  if (discriminant < 0) return {};
  const Real closing = std::sqrt(discriminant) - start.speed;
  if (closing <= 0) return {};
  Real x = 2 * start.separation / closing;
  if (x > 2 * rest) return {};
  constexpr int rounds = 4;
  Approach there;
  for (int round = 0; round < rounds; ++round) {
    there = Encounter(here.row, flight, now + x).of(p);
    if (there.speed >= 0) return {};
    x = std::max(x - there.separation / there.speed, Real{0});
  }
  if (x > rest || there.speed > -flight.slow) return {};
  return {now + x, -Encounter(here.row, flight, now + x).of(p).speed};
}

/// The coefficient up to which friction stops the tangential velocity vt, m/s. A point that slips when it hits slips
/// until friction has stopped it, and meanwhile friction is the dynamic one; only where nothing slips the static
/// coefficient counts.
Real grip_at(const ContactRow& row, Real vt) {
  return std::abs(vt) > no_speed ? row.dynamic_friction : row.static_friction;
}

/// Normal and tangential impulse at one point, satisfying both laws: the normal velocity is reversed and multiplied by
/// e, and the tangential one is stopped if Coulomb's cone allows, otherwise opposed by mu J. K is the 2x2 matrix of
/// inverse effective masses in (n, t).
void strike_one(const ContactRow& row, RowPoint& p, ContactFrame& frame) {
  const Real vn = frame.normal_velocity(p);
  const Real vt = frame.tangent_velocity(p);
  const Real kn = 1 / effective_mass(row, p.cross_a, p.cross_b);
  const Real kt = 1 / effective_mass(row, p.dot_a, p.dot_b);
  const Real knt = row.mass_a.i * p.cross_a * p.dot_a + row.mass_b.i * p.cross_b * p.dot_b;
  const Real wanted = -(1 + row.restitution) * vn;
  if (wanted <= 0) return;  // by rounding: a point that hits approaches

  const Real grip = grip_at(row, vt);
  Vec2 j = Mat22({kn, knt}, {knt, kt}).solve({wanted, -vt});  // sticks
  if (std::abs(j.y) > grip * j.x) {
    const Real mu = j.y < 0 ? -row.dynamic_friction : row.dynamic_friction;
    j.x = wanted / (kn + mu * knt);
    j.y = mu * j.x;
  }
  // Newton's law with friction can create energy at eccentric impacts (Kane and Levinson 1985) and fails if kn + mu knt
  // <= 0 (Painleve); then the normal impulse is computed without friction, and friction only removes energy.
  const Real work = j.x * vn + j.y * vt + (kn * j.x * j.x + 2 * knt * j.x * j.y + kt * j.y * j.y) / 2;
  if (!(j.x > 0) || work > 0) {
    j.x = wanted / kn;
    j.y = -(vt + knt * j.x) / kt;
    if (std::abs(j.y) > grip * j.x) j.y = std::copysign(row.dynamic_friction * j.x, j.y);
  }
  frame.push_normal(row, p, j.x);
  frame.push_tangent(row, p, j.y);
  p.total_normal += j.x;
  p.total_tangent += j.y;
}

/// Two points hit together: the normal impulses solve the 2x2 complementarity problem K J + (1+e) v >= 0, J >= 0;
/// then friction at each.
void strike_two(const ContactRow& row, RowPoint& p, RowPoint& q, ContactFrame& frame) {
  const Real k11 = 1 / effective_mass(row, p.cross_a, p.cross_b);
  const Real k22 = 1 / effective_mass(row, q.cross_a, q.cross_b);
  const Real k12 =
      row.mass_a.m + row.mass_b.m + row.mass_a.i * p.cross_a * q.cross_a + row.mass_b.i * p.cross_b * q.cross_b;
  const Real b1 = -(1 + row.restitution) * frame.normal_velocity(p);
  const Real b2 = -(1 + row.restitution) * frame.normal_velocity(q);
  Vec2 j = Mat22({k11, k12}, {k12, k22}).solve({b1, b2});
  if (!(j.x >= 0 && j.y >= 0)) j = k12 * b1 >= b2 * k11 ? Vec2{b1 / k11, 0} : Vec2{0, b2 / k22};

  const auto push = [&](RowPoint& point, Real normal_impulse) {
    frame.push_normal(row, point, normal_impulse);
    point.total_normal += normal_impulse;
  };
  // Returns whether friction stopped the point.
  const auto solve_friction_at = [&](RowPoint& point, Real most) {
    const Real mass = effective_mass(row, point.dot_a, point.dot_b);
    const Real wanted = point.total_tangent - mass * frame.tangent_velocity(point);
    const Real held = clamp(wanted, -most, most);
    frame.push_tangent(row, point, held - point.total_tangent);
    point.total_tangent = held;
    return held == wanted;
  };
  push(p, j.x);
  push(q, j.y);
  const Real slip = std::max(std::abs(frame.tangent_velocity(p)), std::abs(frame.tangent_velocity(q)));
  const auto stops = [&](Real mu) {
    const bool stops_p = solve_friction_at(p, mu * j.x);
    return solve_friction_at(q, mu * j.y) || stops_p;  // what one cannot bear, the other may
  };
  const Real grip = grip_at(row, slip);
  if (!stops(grip) && grip != row.dynamic_friction) stops(row.dynamic_friction);
}

/// The points that hit: the lower of those that approach, and the other one too if it also almost touches.
struct Struck {
  RowPoint* first;
  RowPoint* second = nullptr;

  Struck(ImpactRow& now, const ContactFrame& frame) : first(&now.points[0]) {
    if (now.count < 2) return;
    second = &now.points[1];
    const auto approaches = [&](const RowPoint& p) { return frame.normal_velocity(p) < 0; };
    if (!approaches(*first) || (approaches(*second) && second->separation < first->separation)) {
      std::swap(first, second);
    }
    if (second->separation >= together || !approaches(*second)) second = nullptr;
  }
};

/// Whether the contact solve must hold the row's points: they touch at the end of the sub-step, or they are not on
/// their way to an impact.
bool stops(const ImpactRow& row, const Flight& flight, Real h) {
  const Encounter start(row, flight, 0);
  const Encounter end(row, flight, h);
  bool under_way = false;
  bool touches = false;  // and must be held whatever the other point does
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
    const RowPoint& p = row.points[i];
    const Approach there = end.of(p);
    touches |= there.separation <= row.offset;
    under_way |= there.separation > 0 && std::min(start.of(p).speed, there.speed) < -flight.slow;
  }
  return touches || !under_way;
}

}  // namespace

/// Resolves the impact of a row at tau: velocities change there, and the start of the sub-step's path shifts so that
/// the path still passes through the bodies' positions at tau.
void Impacts::strike(ImpactRow& row, IslandJoints& joints, std::span<const std::uint32_t> struck, BodySet& bodies,
                     std::vector<Motion>& motion, const std::vector<Velocity>& acceleration, Real tau) {
  const Flight flight{bodies, motion, acceleration, slow_};
  ImpactRow now = Encounter(row, flight, tau).moved();
  for (RowPoint& p : now.points) p.total_normal = p.total_tangent = 0;
  before_.clear();
  for (const std::uint32_t body : struck) {
    if (bodies.inverse_mass[body].m + bodies.inverse_mass[body].i == 0) {
      before_.push_back(bodies.velocity[body]);
      continue;
    }
    bodies.velocity[body] = flight.velocity_at(body, tau);
    before_.push_back(bodies.velocity[body]);
  }

  Velocity& a = bodies.velocity[row.a];
  Velocity& b = bodies.velocity[row.b];
  ContactFrame frame(now, a, b);
  const Struck points(now, frame);
  std::array<Real, 2> target{};
  const std::array<RowPoint*, 2> hit{points.first, points.second};
  for (std::size_t i = 0; i < 2; ++i) {
    if (hit[i] != nullptr) target[i] = -row.restitution * frame.normal_velocity(*hit[i]);
  }
  if (points.second != nullptr) {
    strike_two(now, *points.first, *points.second, frame);
  } else {
    strike_one(now, *points.first, frame);
  }
  frame.write_back(now, a, b);

  std::array<Real, 2> grip{};  // that friction has used, or may
  for (std::size_t i = 0; i < 2; ++i) {
    const RowPoint* p = hit[i];
    if (p == nullptr) continue;
    grip[i] =
        std::max(row.dynamic_friction, p->total_normal > 0 ? std::abs(p->total_tangent) / p->total_normal : Real{0});
  }
  // For a cradle on strings, five and sixty iterations gave equal results.
  constexpr int rounds = 5;
  for (int round = 0; round < rounds && !joints.empty(); ++round) {
    joints.absorb_impact();
    ContactFrame again(now, a, b);
    for (std::size_t i = 0; i < 2; ++i) {
      if (hit[i] == nullptr) continue;
      RowPoint& p = *hit[i];
      const Real more = effective_mass(now, p.cross_a, p.cross_b) * (target[i] - again.normal_velocity(p));
      const Real total = std::max(p.total_normal + more, Real{0});
      again.push_normal(now, p, total - p.total_normal);
      p.total_normal = total;
      const Real rubs = clamp(p.total_tangent, -grip[i] * total, grip[i] * total);
      again.push_tangent(now, p, rubs - p.total_tangent);
      p.total_tangent = rubs;
    }
    again.write_back(now, a, b);
  }

  for (std::size_t i = 0; i < 2; ++i) {
    const RowPoint& given = now.points[i];
    row.note(row.points[i], {given.total_normal, given.total_tangent}, now.normal);
  }
  for (std::size_t i = 0; i < struck.size(); ++i) {
    const std::uint32_t body = struck[i];
    if (bodies.inverse_mass[body].m + bodies.inverse_mass[body].i == 0) continue;
    Velocity& velocity = bodies.velocity[body];
    motion[body].d -= tau * (velocity.v - before_[i].v);
    motion[body].turn_by(-tau * (velocity.w - before_[i].w));
    velocity.v -= tau * acceleration[body].v;
    velocity.w -= tau * acceleration[body].w;
  }
}

/// Order of the heap: the earliest first; at equal times the faster, then the one whose row comes first.
bool Impacts::later(const Event& left, const Event& right) {
  if (left.time != right.time) return left.time > right.time;
  if (left.speed != right.speed) return left.speed < right.speed;
  return left.candidate > right.candidate;
}

/// Schedules the candidate's next impact, and invalidates its earlier events.
void Impacts::aim(std::span<const ImpactRow> rows, std::uint32_t candidate, const BodySet& bodies,
                  const std::vector<Motion>& motion, const std::vector<Velocity>& acceleration, Real now, Real h) {
  Candidate& aimed = candidates_[candidate];
  ++aimed.aims;
  const ImpactRow& row = rows[aimed.row];
  const Flight flight{bodies, motion, acceleration, slow_};
  const Encounter here(row, flight, now);
  Hit first;
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
    const Hit hit = first_hit(here, row.points[i], flight, now, h - now);
    if (hit.time < first.time || (hit.time == first.time && hit.speed > first.speed)) first = hit;
  }
  if (first.time == never) return;
  events_.push_back({first.time, first.speed, candidate, aimed.aims});
  std::push_heap(events_.begin(), events_.end(), later);
}

/// Lists the rows that collide as candidates, and links each to its bodies that an impact can move.
void Impacts::list_candidates(std::span<ImpactRow> rows, std::size_t body_count) {
  candidates_.clear();
  events_.clear();
  first_of_.resize(body_count);
  const auto each_movable = [](const ImpactRow& row, const auto& visit) {
    if (row.mass_a.m + row.mass_a.i > 0) visit(std::size_t{0}, row.a);
    if (row.mass_b.m + row.mass_b.i > 0) visit(std::size_t{1}, row.b);
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].active = true;
    if (!rows[i].collides) continue;
    candidates_.push_back({static_cast<std::uint32_t>(i)});
    each_movable(rows[i], [this](std::size_t, std::uint32_t body) { first_of_[body] = none; });
  }
  for (std::uint32_t c = 0; c < candidates_.size(); ++c) {
    each_movable(rows[candidates_[c].row], [this, c](std::size_t side, std::uint32_t body) {
      candidates_[c].next[side] = std::exchange(first_of_[body], c);
    });
  }
}

void Impacts::resolve(std::span<ImpactRow> rows, IslandJoints& joints, std::span<const std::uint32_t> members,
                      BodySet& bodies, std::vector<Motion>& motion, const std::vector<Velocity>& acceleration, Real h,
                      Real slow, const FindAt& find_at) {
  slow_ = slow;
  list_candidates(rows, bodies.size());
  const auto aim_at = [&](std::uint32_t candidate, Real now) {
    aim(rows, candidate, bodies, motion, acceleration, now, h);
  };
  for (std::uint32_t c = 0; c < candidates_.size(); ++c) aim_at(c, 0);

  // A cradle of n balls needs about n^2/2 impacts; if there are far more in one sub-step, the contact solve ends them.
  const std::size_t most = 64 + 16 * candidates_.size();
  for (std::size_t count = 0; count < most && !events_.empty();) {
    std::pop_heap(events_.begin(), events_.end(), later);
    const Event next = events_.back();
    events_.pop_back();
    if (next.aims != candidates_[next.candidate].aims) continue;
    ++count;
    ImpactRow& hit = rows[candidates_[next.candidate].row];
    const Flight flight{bodies, motion, acceleration, slow_};
    // The plane of a face is reached no later than the face: from there on it goes to what is nearest then.
    if (find_at(hit, flight.motion_at(hit.a, next.time), flight.motion_at(hit.b, next.time))) {
      aim_at(next.candidate, next.time);
      continue;
    }
    const std::array<std::uint32_t, 2> pair{hit.a, hit.b};
    const auto struck = joints.empty() ? std::span<const std::uint32_t>(pair) : members;
    strike(hit, joints, struck, bodies, motion, acceleration, next.time);
    aim_at(next.candidate, next.time);
    for (const bool b : {false, true}) {
      const InverseMass& mass = b ? hit.mass_b : hit.mass_a;
      if (mass.m + mass.i == 0) continue;
      const std::uint32_t body = b ? hit.b : hit.a;
      for (std::uint32_t c = first_of_[body]; c != none;) {
        if (c != next.candidate) aim_at(c, next.time);
        c = candidates_[c].next[rows[candidates_[c].row].b == body ? 1 : 0];
      }
    }
  }

  // The contact solve assumes straight approaches, and would brake bodies that have not arrived at the end or pass by.
  const Flight flight{bodies, motion, acceleration, slow_};
  for (const Candidate& c : candidates_) {
    ImpactRow& row = rows[c.row];
    row.active = stops(row, flight, h);
    if (row.active && find_at(row, flight.motion_at(row.a, h), flight.motion_at(row.b, h))) {
      row.active = stops(row, flight, h);
    }
  }
}

}  // namespace impulse::inline IMPULSE_PRECISION
