#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bodies/body_set.h"
#include "contacts/contact.h"
#include "impulse/world.h"

namespace impulse::inline IMPULSE_PRECISION {

/// Reports which parts began and stopped touching from one step to the next.
class TouchLog {
 public:
  /// Records a step that has been solved. The contacts must be sorted, and of bodies that are awake.
  void note(const BodySet& bodies, std::span<const Contact> contacts);
  ContactEvents events() const { return {begun_, asleep_.empty() ? awake_ : all_, ended_}; }

 private:
  void follow_sleep(const BodySet& bodies);

  std::vector<TouchingParts> begun_, ended_;
  std::vector<TouchingParts> awake_;   // pairs that the last step found touching
  std::vector<TouchingParts> last_;    // the same of the previous step
  std::vector<TouchingParts> asleep_;  // pairs with a body asleep, as they were when it fell asleep
  std::vector<TouchingParts> all_;     // awake_ and asleep_ merged, if any sleep
  std::uint64_t sleep_changes_ = 0;    // of the bodies, at the last note()
};

}  // namespace impulse::inline IMPULSE_PRECISION
