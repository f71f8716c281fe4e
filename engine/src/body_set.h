#pragma once

#include <cstdint>
#include <vector>

#include "impulse/body.h"

namespace impulse::inline IMPULSE_PRECISION {

struct Velocity {
  Vec2 v;           // of the centre of mass, m/s
  Real w = 0;       // rad/s
  Real unused = 0;  // four lanes
};

struct InverseMass {
  Real m = 0;  // 1/kg
  Real i = 0;  // 1/(kg m^2)
};

/// What a step seldom touches.
struct BodyDetail {
  std::uint32_t generation = 0;
  bool alive = false;
  bool inserted = false;
  BodyDef def;              // type, layers, damping, gravity scale as they are now; pose and velocity as at the start
  MassData mass;            // body frame
  std::vector<Part> parts;  // shapes relative to the centre of mass
};

/// The bodies as columns: row i of each is one body. Rows of dead or removed bodies have no parts to collide, inverse
/// mass 0 and velocity 0, so that loops over all rows need no branch. The pose is that of the centre of mass.
struct BodySet {
  std::vector<Pose> pose;
  std::vector<Real> angle;  // the pose's rotation as a number that winds up
  std::vector<Velocity> velocity;
  std::vector<InverseMass> inverse_mass;
  std::vector<Vec2> force;   // N, collected until the next step
  std::vector<Real> torque;  // N m
  std::vector<BodyDetail> detail;

  std::size_t size() const { return pose.size(); }
};

/// Moves row i by h seconds at its velocity.
void advance(BodySet& bodies, std::size_t i, Real h);

}  // namespace impulse::inline IMPULSE_PRECISION
