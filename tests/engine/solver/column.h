#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "solver/island.h"
#include "worlds.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Bodies above each other as one island: row i is of the bodies i and i + 1, of which 0 is fixed.
struct Column {
  BodySet bodies;
  std::vector<std::uint32_t> members;
  std::vector<ImpactRow> rows;
  std::vector<std::uint32_t> acting;  // all of them
  std::vector<Motion> motion;
  std::vector<Pose> start;
  JointWorkspace work;
  Island island;

  /// `masses`: kg, of the bodies from 1 on.
  explicit Column(const std::vector<double>& masses)
      : members(numbers_from(1, masses.size())),
        rows(masses.size()),
        acting(numbers_from(0, masses.size())),
        motion(masses.size() + 1),
        start(masses.size() + 1),
        island{.bodies = members,
               .contacts = {},
               .rows = rows,
               .acting = acting,
               .joints = IslandJoints({}, members, bodies, start, motion, work)} {
    bodies.velocity.resize(masses.size() + 1);
    bodies.inverse_mass.resize(masses.size() + 1);
    bodies.bounding_radius.resize(masses.size() + 1);
    bodies.pose.resize(masses.size() + 1);
    island.h = real(.01);
    for (const std::uint32_t body : members) bodies.inverse_mass[body] = {real(1 / masses[body - 1]), 0};
    for (const std::uint32_t body : members) touch(body - 1, body - 1, body);
  }
  /// Makes `row` one of `b`, which lies on `a`.
  void touch(std::size_t row, std::uint32_t a, std::uint32_t b) {
    ImpactRow& it = rows[row];
    it.a = a;
    it.b = b;
    it.normal = {0, 1};
    it.mass_a = bodies.inverse_mass[a];
    it.mass_b = bodies.inverse_mass[b];
    it.count = 1;
    it.points[0].normal_mass = effective_mass(it, 0, 0);
  }

 private:
  static std::vector<std::uint32_t> numbers_from(std::uint32_t first, std::size_t count) {
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), first);
    return all;
  }
};

}  // namespace impulse::inline IMPULSE_PRECISION
