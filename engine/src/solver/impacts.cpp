#include "solver/impacts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solver/collision.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr Real never = std::numeric_limits<Real>::infinity();

/// The ballistic motion of the bodies.
struct Flight {
  const BodySet& bodies;
  const std::vector<Motion>& motion;
  const std::vector<Velocity>* acceleration;  // none if null
  Real slow;                                  // m/s, approaches below are left to the contact solve
  FlownMotions* kept = nullptr;               // of the times that several contacts ask for

  Velocity acceleration_of(std::uint32_t body) const {
    return acceleration == nullptr ? Velocity{} : (*acceleration)[body];
  }
  Motion motion_at(std::uint32_t body, Real t) const {
    const Velocity& v = bodies.velocity[body];
    const Velocity a = acceleration_of(body);
    Motion at = motion[body];
    if (t == 0) return at;
    if (kept != nullptr && kept->knows(body, t)) return kept->of(body);
    at.d += t * v.v + (t * t / 2) * a.v;
    at.turn_by(t * v.w + (t * t / 2) * a.w);
    if (kept != nullptr) kept->keep(body, t, at);
    return at;
  }
  Velocity velocity_at(std::uint32_t body, Real t) const {
    const Velocity& v = bodies.velocity[body];
    const Velocity a = acceleration_of(body);
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
  Real c = dot(now.normal, flight.acceleration_of(row.b).v - flight.acceleration_of(row.a).v);
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
  Flight once = flight;  // no other contact asks for the times that are tried
  once.kept = nullptr;
  constexpr int rounds = 4;
  Approach there;
  bool settled = false;  // further rounds change nothing
  for (int round = 0; round < rounds && !settled; ++round) {
    there = Encounter(here.row, once, now + x).of(p);
    if (there.speed >= 0) return {};
    const Real last = std::exchange(x, std::max(x - there.separation / there.speed, Real{0}));
    settled = x == last;
  }
  if (x > rest || there.speed > -flight.slow) return {};
  if (!settled) there = Encounter(here.row, once, now + x).of(p);
  return {now + x, -there.speed};
}

/// Whether the contact solve must hold the row's points: they touch at the end of the sub-step, or they are not on
/// their way to an impact.
bool stops(const ImpactRow& row, const Flight& flight, Real h) {
  const Encounter end(row, flight, h);
  std::array<Approach, 2> there;
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
    there[i] = end.of(row.points[i]);
    if (there[i].separation <= row.offset) return true;  // must be held whatever the other point does
  }
  const Encounter start(row, flight, 0);
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
    const bool apart = there[i].separation > 0;
    if (apart && std::min(start.of(row.points[i]).speed, there[i].speed) < -flight.slow) return false;
  }
  return true;
}

}  // namespace

/// Solves an impact, with what joints pass on of it: their response to an impulse is linear.
void Impacts::collide(ImpactRow& now, IslandJoints& joints, std::span<const std::uint32_t> struck, BodySet& bodies) {
  Velocity& a = bodies.velocity[now.a];
  Velocity& b = bodies.velocity[now.b];
  if (!joints.empty()) joints.absorb_impact();
  Collision collision(now, a, b);
  if (joints.empty()) {
    collision.couple();
  } else {
    joined_.clear();
    for (const std::uint32_t body : struck) joined_.push_back(bodies.velocity[body]);
    const auto restore = [&] {
      for (std::size_t i = 0; i < struck.size(); ++i) {
        if (pushable(bodies.inverse_mass[struck[i]])) bodies.velocity[struck[i]] = joined_[i];
      }
    };
    collision.couple([&](const auto& push) {
      restore();
      push(a, b);
      joints.absorb_impact();
      return std::pair(a, b);
    });
    restore();
  }
  collision.solve();
  collision.apply(a, b);
  if (!joints.empty()) joints.absorb_impact();
}

/// Resolves the impact of a row at tau: velocities change there, and the start of the sub-step's path shifts so that
/// the path still passes through the bodies' positions at tau.
void Impacts::strike(ImpactRow& row, IslandJoints& joints, std::span<const std::uint32_t> struck, BodySet& bodies,
                     std::vector<Motion>& motion, const std::vector<Velocity>& acceleration, Real tau) {
  const Flight flight{bodies, motion, &acceleration, slow_, &flown_};
  ImpactRow now = Encounter(row, flight, tau).moved();
  before_.clear();
  for (const std::uint32_t body : struck) {
    if (!pushable(bodies.inverse_mass[body])) {
      before_.push_back(bodies.velocity[body]);
      continue;
    }
    bodies.velocity[body] = flight.velocity_at(body, tau);
    before_.push_back(bodies.velocity[body]);
  }

  for (RowPoint& p : now.points) p.total_normal = p.total_tangent = 0;
  collide(now, joints, struck, bodies);
  for (std::size_t i = 0; i < 2; ++i) {
    const RowPoint& given = now.points[i];
    row.note(row.points[i], given, now.normal, {given.total_normal, given.total_tangent});
  }
  for (std::size_t i = 0; i < struck.size(); ++i) {
    const std::uint32_t body = struck[i];
    if (!pushable(bodies.inverse_mass[body])) continue;
    flown_.forget(body);
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
  // In a jam bodies would be struck again and again, and get nowhere.
  if (aimed.struck && is_deep(row.points)) return;
  const Flight flight{bodies, motion, &acceleration, slow_, &flown_};
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

/// Lists the rows whose impacts are events as candidates, and links each to its bodies that an impact can move.
void Impacts::list_candidates(std::span<ImpactRow> rows, std::size_t body_count) {
  candidates_.clear();
  events_.clear();
  first_of_.resize(body_count);
  const auto each_movable = [](const ImpactRow& row, const auto& visit) {
    if (pushable(row.mass_a)) visit(std::size_t{0}, row.a);
    if (pushable(row.mass_b)) visit(std::size_t{1}, row.b);
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].active = true;
    if (!rows[i].strikes) continue;
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
  began_.resize(bodies.size());
  for (const std::uint32_t body : members) began_[body] = motion[body];
  flown_.begin(rows, bodies.size());
  list_candidates(rows, bodies.size());
  const auto aim_at = [&](std::uint32_t candidate, Real now) {
    aim(rows, candidate, bodies, motion, acceleration, now, h);
  };
  for (std::uint32_t c = 0; c < candidates_.size(); ++c) aim_at(c, 0);

  // A cradle of n balls needs about n^2/2 impacts; if there are far more in one sub-step, the contact solve ends them.
  // Elastic ones lose nothing: a light block m between a heavy one M and a wall needs pi sqrt(M/m), 5000 at 2.5e6.
  const std::size_t most = 64 + 16 * candidates_.size();
  constexpr std::size_t most_elastic = 5000;
  std::size_t count = 0;
  std::size_t elastic = 0;
  while (count < most && elastic < most_elastic && !events_.empty()) {
    std::pop_heap(events_.begin(), events_.end(), later);
    const Event next = events_.back();
    events_.pop_back();
    if (next.aims != candidates_[next.candidate].aims) continue;
    ImpactRow& hit = rows[candidates_[next.candidate].row];
    ++(hit.restitution < 1 ? count : elastic);
    const Flight flight{bodies, motion, &acceleration, slow_, &flown_};
    // The plane of a face is reached no later than the face: from there on it goes to what is nearest then.
    if (find_at(hit, flight.motion_at(hit.a, next.time), flight.motion_at(hit.b, next.time))) {
      aim_at(next.candidate, next.time);
      continue;
    }
    candidates_[next.candidate].struck = true;
    const std::array<std::uint32_t, 2> pair{hit.a, hit.b};
    const auto struck = joints.empty() ? std::span<const std::uint32_t>(pair) : members;
    strike(hit, joints, struck, bodies, motion, acceleration, next.time);
    aim_at(next.candidate, next.time);
    for (const bool b : {false, true}) {
      const InverseMass& mass = b ? hit.mass_b : hit.mass_a;
      if (!pushable(mass)) continue;
      const std::uint32_t body = b ? hit.b : hit.a;
      for (std::uint32_t c = first_of_[body]; c != none;) {
        if (c != next.candidate) aim_at(c, next.time);
        c = candidates_[c].next[rows[candidates_[c].row].b == body ? 1 : 0];
      }
    }
  }

  struck_ = count + elastic > 0;
  // The contact solve assumes straight approaches, and would brake bodies that have not arrived at the end or pass by.
  const Flight flight{bodies, motion, &acceleration, slow_, &flown_};
  for (const Candidate& c : candidates_) {
    ImpactRow& row = rows[c.row];
    row.active = stops(row, flight, h);
    if (row.active && find_at(row, flight.motion_at(row.a, h), flight.motion_at(row.b, h))) {
      row.active = stops(row, flight, h);
    }
  }
}

/// A path that an impact has shifted passes through where the bodies met, unless others stop them after it, in the same
/// sub-step. From its start they must then part by what was shifted.
void Impacts::note_paths(std::span<ImpactRow> rows, const std::vector<Motion>& motion, Real h) const {
  if (!struck_) return;
  for (ImpactRow& row : rows) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
      const RowPoint& p = row.points[i];
      const Real began = separation(row, p, began_[row.a], began_[row.b]);
      const Real begins = separation(row, p, motion[row.a], motion[row.b]);
      row.parts[i] = std::max(std::min(began, Real{0}) - begins, Real{0}) / h;
    }
  }
}

void Impacts::forget_paths(std::span<ImpactRow> rows) {
  for (ImpactRow& row : rows) row.parts = {};
}

bool Impacts::hold_those_that_meet(std::span<ImpactRow> rows, const BodySet& bodies, const std::vector<Motion>& motion,
                                   Real h, Real most, const FindAt& find_at) {
  flown_.begin(rows, bodies.size());
  const Flight drift{bodies, motion, nullptr, slow_, &flown_};
  const auto meet = [&](const ImpactRow& row) {
    const Encounter start(row, drift, 0);
    const Encounter end(row, drift, h);
    const auto deepens = [&](std::size_t i) {
      const RowPoint& p = row.points[i];
      const Real there = end.of(p).separation;
      const Real began = start.of(p).separation + h * row.parts[i];
      return there < -most && there < std::min(began, Real{0}) - most;
    };
    return (row.count > 0 && deepens(0)) || (row.count > 1 && deepens(1));
  };
  bool any = false;
  for (ImpactRow& row : rows) {
    if (row.active || row.nearest() > h * fastest_nearing(row, bodies)) continue;
    row.active = meet(row);
    // The plane of a face is reached no later than the face.
    if (row.active && find_at(row, drift.motion_at(row.a, h), drift.motion_at(row.b, h))) row.active = meet(row);
    any |= row.active;
  }
  return any;
}

}  // namespace impulse::inline IMPULSE_PRECISION
