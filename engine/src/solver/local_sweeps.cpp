#include "solver/local_sweeps.h"

namespace impulse::inline IMPULSE_PRECISION {

bool LocalSweeps::find(const Island& island, const ScalarContacts& contacts, std::size_t bodies, Real in_step,
                       bool held) {
  ring_.resize(bodies);
  for (const std::uint32_t body : island.bodies) ring_[body] = 0;
  // What cannot be pushed passes nothing on, and may belong to other islands too.
  const auto mark = [&](std::uint32_t body, const InverseMass& mass, std::uint8_t ring) {
    if (ring_[body] == 0 && pushable(mass)) ring_[body] = ring;
  };
  const auto in = [&](std::uint32_t body, const InverseMass& mass) { return pushable(mass) ? ring_[body] : 0; };

  bool any = false;
  for (const std::uint32_t index : island.acting) {
    const ImpactRow& row = island.rows[index];
    if (!contacts.deepens(island, row, in_step, held)) continue;
    any = true;
    mark(row.a, row.mass_a, 1);
    mark(row.b, row.mass_b, 1);
  }
  if (!any) return false;
  for (const std::uint32_t index : island.acting) {
    const ImpactRow& row = island.rows[index];
    if (in(row.a, row.mass_a) == 1) mark(row.b, row.mass_b, 2);
    if (in(row.b, row.mass_b) == 1) mark(row.a, row.mass_a, 2);
  }
  rows_.clear();
  for (const std::uint32_t index : island.acting) {
    const ImpactRow& row = island.rows[index];
    if (in(row.a, row.mass_a) != 0 || in(row.b, row.mass_b) != 0) rows_.push_back(index);
  }
  return !rows_.empty() && 2 * rows_.size() <= island.acting.size();
}

}  // namespace impulse::inline IMPULSE_PRECISION
