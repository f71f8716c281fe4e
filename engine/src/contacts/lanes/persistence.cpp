#include "contacts/lanes/persistence.h"

#include "narrow_phase/lanes/pair_lanes.h"

namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

namespace {

struct PoseLanes {
  Vec2Lanes p;
  RotationLanes q;
};

PoseLanes gather_poses(const Real* const* rows) {
  Lanes columns[4];
  Lanes::gather(rows, columns);
  return {{columns[0], columns[1]}, {columns[2], columns[3]}};
}

/// The motion of a body between two poses.
struct MovedLanes {
  Vec2Lanes by;
  RotationLanes turn;

  MovedLanes(const PoseLanes& now, const PoseLanes& then) : by(now.p - then.p), turn(now.q * then.q.inverse()) {}
  /// The greatest displacement of a point within reach.
  Lanes displacement(const Lanes& reach) const { return length(by) + abs(turn.s) * reach; }
};

}  // namespace

void persist_points(Contact* contacts, const std::uint32_t* items, std::uint32_t count, const Pose* poses,
                    const Real* reach, PersistenceLimit limit, std::uint8_t* kept) {
  const Lanes most = Lanes::all(limit.motion);
  const Lanes most_turn = Lanes::all(limit.turn);
  for (std::uint32_t from = 0; from < count; from += lane_count) {
    const Real* normals[lane_count];
    const Real* poses_a[lane_count];
    const Real* poses_b[lane_count];
    const Real* found_a[lane_count];
    const Real* found_b[lane_count];
    const Real* arms[2][lane_count];
    Real reach_a[lane_count];
    Real reach_b[lane_count];
    Real turns_a[lane_count];  // 1: its turning turns the contact, as that of a disc about its centre does not
    Real turns_b[lane_count];
    for (std::uint32_t lane = 0; lane < lane_count; ++lane) {
      const bool present = from + lane < count;
      const Contact& contact = contacts[items[present ? from + lane : from]];
      const auto* points = reinterpret_cast<const ContactPoint*>(&contact.points);
      normals[lane] = &contact.normal.x;
      poses_a[lane] = &poses[contact.body_a].p.x;
      poses_b[lane] = &poses[contact.body_b].p.x;
      found_a[lane] = &contact.found_a.p.x;
      found_b[lane] = &contact.found_b.p.x;
      arms[0][lane] = &points[0].arm_a.x;
      arms[1][lane] = &points[1].arm_a.x;
      reach_a[lane] = reach[contact.body_a];
      reach_b[lane] = reach[contact.body_b];
      turns_a[lane] = contact.disc_a ? Real{0} : Real{1};
      turns_b[lane] = contact.disc_b ? Real{0} : Real{1};
    }
    const MovedLanes a(gather_poses(poses_a), gather_poses(found_a));
    const MovedLanes b(gather_poses(poses_b), gather_poses(found_b));
    Lanes head[4];
    Lanes::gather(normals, head);
    const Vec2Lanes normal{head[0], head[1]};
    const Vec2Lanes apart = b.by - a.by;
    Real separation[2][lane_count];
    for (std::uint32_t p = 0; p < 2; ++p) {
      Lanes arm[4];
      Lanes::gather(arms[p], arm);
      const Vec2Lanes arm_a{arm[0], arm[1]};
      const Vec2Lanes arm_b{arm[2], arm[3]};
      const Vec2Lanes turned = (b.turn * arm_b - arm_b) - (a.turn * arm_a - arm_a);
      (head[2 + p] + dot(normal, apart + turned)).store(separation[p]);
    }
    const Lanes motion = a.displacement(Lanes::load(reach_a)) + b.displacement(Lanes::load(reach_b));
    const Lanes turn = abs(a.turn.s) * Lanes::load(turns_a) + abs(b.turn.s) * Lanes::load(turns_b);
    const std::uint32_t stay = (motion < most).bits() & (turn < most_turn).bits();
    for (std::uint32_t lane = 0; lane < lane_count && from + lane < count; ++lane) {
      kept[from + lane] = stay >> lane & 1U;
      if (kept[from + lane] == 0) continue;
      Contact& contact = contacts[items[from + lane]];
      ++contact.age;
      auto* points = reinterpret_cast<ContactPoint*>(&contact.points);
      for (std::int32_t p = 0; p < contact.count; ++p) {
        points[p].separation = separation[p][lane];
      }
    }
  }
}

extern const ContactKernels contact_table;
const ContactKernels contact_table{persist_points};

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
