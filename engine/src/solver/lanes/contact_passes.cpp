#include "solver/lanes/contact_frame.h"

namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

namespace {

/// A parameter of SoftRule for each lane.
Lanes by_lane(const SoftRule::Choice& choice, const Lanes::Mask& web, const Lanes::Mask& fixed) {
  return select(web, select(fixed, Lanes::all(choice[1][1]), Lanes::all(choice[1][0])),
                select(fixed, Lanes::all(choice[0][1]), Lanes::all(choice[0][0])));
}

/// The motions of both bodies since the start of the step.
struct LanesMotion {
  Lanes a[4], b[4];

  template <class Contacts>
  LanesMotion(const Contacts& contacts, Real* motion) {
    Lanes::gather(NamedRows{motion, contacts.a}, a);
    Lanes::gather(NamedRows{motion, contacts.b}, b);
  }
};

template <class Contacts>
[[gnu::always_inline]] inline void find_gaps(Contacts& contacts, const LanesMotion& motion) {
  static constexpr Row<lane_count> sharp{};  // m, the radii of shapes without rounding
  const auto& [a, b] = motion;
  const Lanes along = load(contacts.normal_x) * (b[0] - a[0]) + load(contacts.normal_y) * (b[1] - a[1]);
  for (auto& p : contacts.point) {
    const Lanes centres = load(p.separation) + along;
    if constexpr (rubs<Contacts>) {
      const Lanes turn_a = load(p.dot_a) - load(contacts.rounded ? contacts.radius_a : sharp);
      const Lanes turn_b = load(p.dot_b) + load(contacts.rounded ? contacts.radius_b : sharp);
      store(centres + (b[2] * load(p.cross_b) + b[3] * turn_b) - (a[2] * load(p.cross_a) + a[3] * turn_a), p.gap);
    } else {
      store(centres, p.gap);
    }
  }
}

/// Solves two points together, (K + G) d = -(v + bias + G lambda), see push_both() of ScalarContacts: a point that
/// would pull bears nothing. Lanes where `holds` is not set must be solved point by point.
struct SolvedPair {
  Lanes impulse[2];
  Lanes::Mask holds;
};
[[gnu::always_inline]] inline SolvedPair solve_pair(const ContactLanes<2>& contacts, const LanesFrame& frame,
                                                    const Lanes impulse[2], const Lanes give[2], const Lanes bias[2]) {
  const PointLanes& p = contacts.point[0];
  const PointLanes& q = contacts.point[1];
  const Lanes one = Lanes::all(1);
  const Lanes nothing = Lanes::all(0);
  const Lanes k11 = one / load(p.normal_mass) + give[0];
  const Lanes k22 = one / load(q.normal_mass) + give[1];
  const Lanes k12 = frame.mass + frame.inertia_a * load(p.cross_a) * load(q.cross_a) +
                    frame.inertia_b * load(p.cross_b) * load(q.cross_b);
  const Lanes determinant = k11 * k22 - k12 * k12;
  const Lanes wanted_p = -(frame.normal_velocity(p) + bias[0] + give[0] * impulse[0]);
  const Lanes wanted_q = -(frame.normal_velocity(q) + bias[1] + give[1] * impulse[1]);
  const Lanes both_p = impulse[0] + (wanted_p * k22 - k12 * wanted_q) / determinant;
  const Lanes both_q = impulse[1] + (k11 * wanted_q - wanted_p * k12) / determinant;
  const Lanes::Mask push = (nothing <= both_p) & (nothing <= both_q);
  // What each would bear alone, and whether q parts from p's impulse. K is positive definite, so that one of the four
  // answers alone is right: neither both nor p, hence q if it pushes.
  const Lanes of_p = impulse[0] + (wanted_p + k12 * impulse[1]) / k11;
  const Lanes of_q = impulse[1] + (wanted_q + k12 * impulse[0]) / k22;
  const Lanes left_q = wanted_q + k22 * impulse[1] - k12 * (of_p - impulse[0]);
  const Lanes::Mask only_p = (nothing <= of_p) & (left_q <= nothing);
  SolvedPair pair;
  pair.impulse[0] = select(push, both_p, select(only_p, of_p, nothing));
  pair.impulse[1] = select(push, both_q, select(only_p, nothing, max(nothing, of_q)));
  // The matrix of two points almost in one place does not determine the difference of their loads.
  const Lanes worst_condition = Lanes::all(1000);
  pair.holds = k11 * k22 <= worst_condition * determinant;
  return pair;
}

/// Applies the impulses of pairs that were solved together; other lanes are solved point by point.
template <class Each>
[[gnu::always_inline]] inline void push_points(ContactLanes<2>& contacts, LanesFrame& frame, Lanes impulse[2],
                                               const SolvedPair& pair, Each wanted) {
  for (std::uint32_t i = 0; i < 2; ++i) {
    const Lanes next = select(pair.holds, pair.impulse[i], wanted(i));
    frame.push_normal(contacts.point[i], next - impulse[i]);
    impulse[i] = next;
  }
}

/// Friction at all points, from the tangential impulses `now` on and into them, in the lanes of `where` only; see
/// solve_friction_by_state() of ScalarContacts.
template <class Contacts>
[[gnu::always_inline]] inline void solve_friction_together(const Contacts& contacts, LanesFrame& frame,
                                                           const Lanes impulse[2], const Lanes::Mask& where,
                                                           Lanes now[2]) {
  const Lanes mu = load(contacts.friction);
  const auto stop = [&](const PointLanes& p, const Lanes& sliding, const Lanes& normal, Lanes& rubbed) {
    const Lanes wanted = rubbed - load(p.tangent_mass) * sliding;
    const Lanes most = mu * normal;
    const Lanes held = select(where, max(-most, min(most, wanted)), rubbed);
    frame.push_tangent(p, held - rubbed);
    rubbed = held;
  };
  const auto& first = contacts.point[0];
  if constexpr (std::extent_v<decltype(contacts.point)> == 1) {
    stop(first, frame.tangent_velocity(first), impulse[0], now[0]);
  } else {
    const auto& second = contacts.point[1];
    const Lanes one = Lanes::all(1);
    const Lanes load = impulse[0] + impulse[1];
    const Lanes share = select(Lanes::all(0) < load, impulse[0] / load, one / Lanes::all(2));
    const Lanes of_first = share * frame.tangent_velocity(first);
    const Lanes of_second = (one - share) * frame.tangent_velocity(second);
    stop(first, of_first, impulse[0], now[0]);
    stop(second, of_second, impulse[1], now[1]);
  }
}

/// Friction before the drift for contacts in their first step.
template <class Contacts>
[[gnu::always_inline]] inline void solve_new_friction(Contacts& contacts, LanesFrame& frame, const Lanes impulse[2]) {
  const std::uint32_t points = count_points(contacts);
  Lanes half[2];
  Lanes now[2];
  for (std::uint32_t i = 0; i < points; ++i) {
    half[i] = Lanes::all(Real{1} / 2) * load(contacts.point[i].tangent_impulse);
    now[i] = half[i];
  }
  solve_friction_together(contacts, frame, impulse, Lanes::Mask::of(contacts.fresh), now);
  for (std::uint32_t i = 0; i < points; ++i) store(now[i] + half[i], contacts.point[i].tangent_impulse);
}

template <bool block, class Contacts>
void press(Contacts& contacts, FrameOf<Contacts>& frame, const SoftRule& soft, const Lanes& per_h) {
  const Lanes nothing = Lanes::all(0);
  const auto web = Lanes::Mask::of(contacts.web);
  const auto fixed = Lanes::Mask::of(contacts.fixed);
  const Lanes strength = by_lane(soft.strength, web, fixed);
  const Lanes rate = by_lane(soft.rate, web, fixed);
  const Lanes relief = by_lane(soft.relief, web, fixed);
  const std::uint32_t points = count_points(contacts);
  Lanes half[2];
  Lanes impulse[2];
  for (std::uint32_t i = 0; i < points; ++i) {
    half[i] = Lanes::all(Real{1} / 2) * load(contacts.point[i].normal_impulse);
    impulse[i] = half[i];
  }
  const auto spring = [&](std::uint32_t i) {
    const auto& p = contacts.point[i];
    const Lanes s = load(p.gap);
    const Lanes v = frame.normal_velocity(p);
    const Lanes mass = load(p.normal_mass);
    const Lanes closing = impulse[i] - mass * (v + s * per_h);
    const Lanes giving = impulse[i] - (mass * strength * (v + rate * s) + relief * impulse[i]);
    return max(select(Lanes::all(touching_gap) < s, closing, giving), nothing);
  };
  if constexpr (block) {
    Lanes give[2];
    Lanes bias[2];
    for (std::uint32_t i = 0; i < 2; ++i) {
      const PointLanes& p = contacts.point[i];
      const Lanes s = load(p.gap);
      give[i] = select(Lanes::all(touching_gap) < s, nothing,
                       (Lanes::all(1) / strength - Lanes::all(1)) / load(p.normal_mass));
      bias[i] = select(Lanes::all(touching_gap) < s, s * per_h, rate * s);
    }
    push_points(contacts, frame, impulse, solve_pair(contacts, frame, impulse, give, bias), spring);
  } else {
    for (std::uint32_t i = 0; i < points; ++i) {
      const Lanes next = spring(i);
      frame.push_normal(contacts.point[i], next - impulse[i]);
      impulse[i] = next;
    }
  }
  if constexpr (rubs<Contacts>) {
    if (contacts.fresh != 0) solve_new_friction(contacts, frame, impulse);
  }
  // Includes the second half, which the bodies get with the kick after the drift.
  for (std::uint32_t i = 0; i < points; ++i) store(impulse[i] + half[i], contacts.point[i].normal_impulse);
}

template <bool block, bool again, class Contacts>
void relax(Contacts& contacts, FrameOf<Contacts>& frame) {
  const Lanes nothing = Lanes::all(0);
  const std::uint32_t points = count_points(contacts);
  Lanes impulse[2];
  Lanes before[2];
  Lanes::Mask idle[2];
  for (std::uint32_t i = 0; i < points; ++i) {
    auto& p = contacts.point[i];
    impulse[i] = load(p.normal_impulse);
    before[i] = again ? impulse[i] : nothing;
    idle[i] = (impulse[i] == nothing) & (Lanes::all(touching_gap) < load(p.gap));
  }
  const auto rigid = [&](std::uint32_t i) {
    const auto& p = contacts.point[i];
    const Lanes next = max(impulse[i] - load(p.normal_mass) * frame.normal_velocity(p), nothing);
    return select(idle[i], impulse[i], next);
  };
  if constexpr (block) {
    const Lanes none[2] = {nothing, nothing};
    SolvedPair pair = solve_pair(contacts, frame, impulse, none, none);
    pair.holds = pair.holds & !(idle[0] | idle[1]);
    push_points(contacts, frame, impulse, pair, rigid);
  } else {
    for (std::uint32_t i = 0; i < points; ++i) {
      const Lanes next = rigid(i);
      frame.push_normal(contacts.point[i], next - impulse[i]);
      impulse[i] = next;
    }
  }
  for (std::uint32_t i = 0; i < points; ++i) {
    auto& p = contacts.point[i];
    store(impulse[i], p.normal_impulse);
    store(load(p.total_normal) + (impulse[i] - before[i]), p.total_normal);
  }
  if constexpr (rubs<Contacts>) {
    Lanes rubbed[2];
    Lanes last[2];
    for (std::uint32_t i = 0; i < points; ++i) last[i] = rubbed[i] = load(contacts.point[i].tangent_impulse);
    solve_friction_together(contacts, frame, impulse, Lanes::Mask::of(all_lanes), rubbed);
    for (std::uint32_t i = 0; i < points; ++i) {
      auto& p = contacts.point[i];
      store(rubbed[i], p.tangent_impulse);
      store(load(p.total_tangent) + (again ? rubbed[i] - last[i] : rubbed[i]), p.total_tangent);
    }
  }
}

/// Updates the normal to the current centres; the gap is measured along it.
template <class Discs>
void turn_normal(Discs& contacts, const LanesMotion& motion) {
  const Lanes x = load(contacts.between_x) + (motion.b[0] - motion.a[0]);
  const Lanes y = load(contacts.between_y) + (motion.b[1] - motion.a[1]);
  const Lanes length = sqrt(x * x + y * y);
  const auto apart = Lanes::all(0) < length;
  const Lanes normal_x = select(apart, x / length, load(contacts.normal_x));
  const Lanes normal_y = select(apart, y / length, load(contacts.normal_y));
  store(normal_x, contacts.normal_x);
  store(normal_y, contacts.normal_y);
  const Lanes between = normal_x * load(contacts.between_x) + normal_y * load(contacts.between_y);
  store(between - load(contacts.distance) - load(contacts.offset), contacts.point[0].separation);
}

/// See ScalarContacts::turn_normal: the impulses of press follow the normal.
template <bool again, class Discs>
void relax_discs(Discs& discs, const LanesMotion& motion, Real* velocity) {
  const Lanes before_x = load(discs.normal_x);
  const Lanes before_y = load(discs.normal_y);
  turn_normal(discs, motion);
  find_gaps(discs, motion);
  FrameOf<Discs> frame(discs, velocity);
  if constexpr (!again) {
    const Lanes change_x = frame.normal_x - before_x;
    const Lanes change_y = frame.normal_y - before_y;
    const Lanes along = load(discs.point[0].normal_impulse);
    if constexpr (rubs<Discs>) {
      const Lanes across = load(discs.point[0].tangent_impulse);
      frame.push_centres(along * change_x - across * change_y, along * change_y + across * change_x);
    } else {
      frame.push_centres(along * change_x, along * change_y);
    }
  }
  relax<false, again>(discs, frame);
  frame.write_back();
}

void begin_late(const ContactTable& table, const BodyRows& bodies) {
  for_all_lanes(table, [&]<class Contacts>(Contacts& contacts, auto) {
    const LanesMotion motion(contacts, bodies.motion);
    find_gaps(contacts, motion);
    for (auto& p : contacts.point) {
      const Lanes now = load(p.separation);
      store(now - (load(p.gap) - now), p.separation);
      store(now, p.gap);
    }
    if constexpr (is_discs<Contacts>) {
      store(load(contacts.between_x) - (motion.b[0] - motion.a[0]), contacts.between_x);
      store(load(contacts.between_y) - (motion.b[1] - motion.a[1]), contacts.between_y);
    }
  });
}

void kick_by_contacts(const ContactTable& table, const BodyRows& bodies) {
  const Lanes half = Lanes::all(Real{1} / 2);
  for_all_lanes(table, [&]<class Contacts>(Contacts& contacts, auto) {
    FrameOf<Contacts> frame(contacts, bodies.kick);
    Lanes a[4];
    Lanes b[4];
    Lanes::gather(NamedRows{bodies.velocity, contacts.a}, a);
    Lanes::gather(NamedRows{bodies.velocity, contacts.b}, b);
    frame.weigh(a[3], b[3]);
    for (auto& p : contacts.point) {
      frame.push_normal(p, half * load(p.normal_impulse));
      store(Lanes::all(0), p.total_normal);
      if constexpr (rubs<Contacts>) {
        frame.push_tangent(p, half * load(p.tangent_impulse));
        store(Lanes::all(0), p.total_tangent);
      }
    }
    frame.write_back();
  });
}

void press_contacts(const ContactTable& table, const BodyRows& bodies, const SoftRule& soft, Real h) {
  const Lanes per_h = Lanes::all(1 / h);
  for_all_lanes(table, [&]<class Contacts>(Contacts& contacts, auto block) {
    FrameOf<Contacts> frame(contacts, bodies.velocity);
    press<block>(contacts, frame, soft, per_h);
    frame.write_back();
  });
}

template <bool again>
void relax_once(const ContactTable& table, const BodyRows& bodies) {
  for_all_lanes(table, [&]<class Contacts>(Contacts& contacts, auto block) {
    const LanesMotion motion(contacts, bodies.motion);
    if constexpr (is_discs<Contacts>) {
      relax_discs<again>(contacts, motion, bodies.velocity);
    } else {
      find_gaps(contacts, motion);
      FrameOf<Contacts> frame(contacts, bodies.velocity);
      relax<block, again>(contacts, frame);
      frame.write_back();
    }
  });
}

void relax_contacts(const ContactTable& table, const BodyRows& bodies, bool again) {
  again ? relax_once<true>(table, bodies) : relax_once<false>(table, bodies);
}

template <class Contacts>
void choose_friction(Contacts& contacts) {
  store(select(Lanes::Mask::of(contacts.slips), load(contacts.dynamic_friction), load(contacts.static_friction)),
        contacts.friction);
}

void meet_contacts(const ContactTable& table, const BodyRows& bodies, Real slow) {
  const Lanes nothing = Lanes::all(0);
  for_all_lanes(table, [&]<class Contacts>(Contacts& contacts, auto) {
    if constexpr (rubs<Contacts>) {
      if (contacts.two_frictions == 0) return;
      const LanesFrame frame(contacts, bodies.velocity);
      std::uint32_t idle = all_lanes;
      std::uint32_t slips = 0;
      for (const auto& p : contacts.point) {
        const Lanes speed = frame.tangent_velocity(p);
        idle &= (load(p.normal_impulse) == nothing).bits();
        slips |= (Lanes::all(slow) < max(speed, -speed)).bits();
      }
      contacts.slips = (contacts.slips & ~idle) | (slips & idle);
      choose_friction(contacts);
    }
  });
}

bool stick_or_slip(const ContactTable& table, const BodyRows& bodies, Real slow, Real slow_in_web) {
  bool broke = false;
  for_all_lanes(table, [&]<class Contacts>(Contacts& contacts, auto) {
    if constexpr (rubs<Contacts>) {
      if (contacts.two_frictions == 0) return;
      const LanesFrame frame(contacts, bodies.velocity);
      const Lanes mu = load(contacts.friction);
      const Lanes least = select(Lanes::Mask::of(contacts.web), Lanes::all(slow_in_web), Lanes::all(slow));
      std::uint32_t slips = contacts.two_frictions;
      std::uint32_t moves = 0;
      for (const auto& p : contacts.point) {
        const Lanes rubbed = load(p.tangent_impulse);
        const Lanes speed = frame.tangent_velocity(p);
        slips &= (mu * load(p.normal_impulse) <= max(rubbed, -rubbed)).bits();
        moves |= (least < max(speed, -speed)).bits();
      }
      slips &= moves;
      broke |= (slips & ~contacts.slips) != 0;
      contacts.slips = slips;
      choose_friction(contacts);
    }
  });
  return broke;
}

// See ScalarContacts::settle_offsets.
void settle_offsets(const ContactTable& table, const SoftRule& soft, bool settling) {
  const Lanes nothing = Lanes::all(0);
  const Lanes leak = Lanes::all(soft.leak);
  for_all_lanes(table, [&](auto& contacts, auto) {
    const Lanes offset = load(contacts.offset);
    Lanes sum = nothing;
    Lanes speed = nothing;
    Lanes depth = nothing;
    for (const auto& p : contacts.point) {
      const Lanes mass = load(p.normal_mass);
      const Lanes impulse = load(p.normal_impulse);
      sum = sum + impulse;
      speed = speed + select(nothing < mass, impulse * (impulse / mass), nothing);
      depth = depth - impulse * (load(p.gap) + offset);
    }
    const auto web = Lanes::Mask::of(contacts.web);
    const auto fixed = Lanes::Mask::of(contacts.fixed);
    const Lanes give = by_lane(soft.give, web, fixed);
    const Lanes gain = by_lane(soft.gain, web, fixed);
    const auto loaded = nothing < sum;
    const Lanes explained = select(loaded, speed / sum, nothing) * give;
    const Lanes mean = select(loaded, depth / sum, nothing);
    const Lanes headroom = Lanes::all(static_cast<Real>(1.05));
    const Lanes next = max(nothing, min(headroom * explained, offset + (gain * mean - leak * offset)));
    const Lanes chosen = settling ? explained : select(Lanes::Mask::of(contacts.aged), next, offset);
    store(chosen, contacts.offset);
    const Lanes change = chosen - offset;
    for (auto& p : contacts.point) {
      store(load(p.separation) - change, p.separation);
      store(load(p.gap) - change, p.gap);
    }
  });
}

}  // namespace

extern const ContactPasses<lane_count> contact_passes;
const ContactPasses<lane_count> contact_passes{lay_out_contacts, begin_late,     kick_by_contacts,
                                               press_contacts,   relax_contacts, meet_contacts,
                                               stick_or_slip,    settle_offsets, store_contacts};

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
