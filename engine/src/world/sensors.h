#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "bodies/body_set.h"
#include "broad_phase/broad_phase.h"
#include "impulse/contact.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Finds what overlaps sensors, apart from the contacts: a world moves with the same bits with and without them.
class Sensors {
 public:
  Sensors();
  /// Copies the overlaps.
  Sensors(const Sensors& other);
  Sensors& operator=(const Sensors&) = delete;

  /// Records the overlaps at the end of a step. Free while no body has a sensor.
  void update(const BodySet& bodies);
  SensorEvents events() const { return {begun_, overlapping_, ended_}; }

 private:
  void list(const BodySet& bodies);
  void find_overlaps(const BodySet& bodies);

  std::vector<SensorOverlap> begun_, overlapping_, ended_, last_;
  std::uint64_t part_changes_ = ~std::uint64_t{0};  // of the bodies, at the last list()
  std::size_t count_ = 0;                           // of sensors
  std::vector<Proxy> proxies_;                      // those that "move" are the sensors
  std::vector<Pair> pairs_;
  std::unique_ptr<BroadPhase> broad_phase_;
};

}  // namespace impulse::inline IMPULSE_PRECISION
