#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "scenarios/scenario.h"
#include "scenarios/scene/scene.h"

namespace plumb {

/// How far a body has moved, small against the scene.
struct Sag {
  Vec shift;        // m, of the centre of mass
  double turn = 0;  // rad
};

/// How far each body of a scene at rest sags under its own weight where hinges and welds are springs of this frequency,
/// Hz (see Stepping::joint_frequency).
std::vector<Sag> sag_of(const Scene&, double frequency);

/// m, of one body's centre, and rad, where a method makes joints springs.
inline double sag(const Stepping& s, const Scene& scene, std::size_t body) {
  return s.joint_frequency > 0 ? length(sag_of(scene, s.joint_frequency)[body].shift) : 0;
}
inline double sag_angle(const Stepping& s, const Scene& scene, std::size_t body) {
  return s.joint_frequency > 0 ? std::abs(sag_of(scene, s.joint_frequency)[body].turn) : 0;
}

}  // namespace plumb
