#pragma once

#include <cstddef>
#include <vector>

#include "reports/trace.h"
#include "scenarios/scenario.h"

/// The position error that a method makes by itself along a known motion, before the scene amplifies it. From the
/// motion and what the method states alone, never from a run of the method.
namespace plumb {

/// How a motion stresses methods, up to one of its moments: the largest over all dynamic bodies. Speeds include those
/// of the rim.
struct Stress {
  double smooth = 0;   // m/s, the sum of all changes of velocity while nothing pushed the body
  double bends = 0;    // m/s^2, the sum of all changes of acceleration but those as a contact begins or ends
  double pushed = 0;   // m/s, the sum of all changes of velocity by contacts
  double carried = 0;  // m, the sum of all changes of velocity, each times the time since
  double slowest = 0;  // m/s, the smallest change of velocity at an impact; 0: none
  double touched = 0;  // s, since the first contact
  double time = 0;     // s
  int contacts = 0;    // bodies in the largest group that contacts and joints have connected, if one has touched
  int joints = 0;      // bodies in the largest group that joints connect
};

/// One per moment of a trace that reports contacts.
std::vector<Stress> stress_along(const Scene&, const Trace&);

/// m, the largest position error of a method in such a motion. The sum of
/// - a method of first order applies each change of velocity too early or too late by up to h/2 (the
///   free fall of symplectic Euler, g t h/2, is such a sum), or as its drift states; one of second order is off by
///   h^2/6 times the changes of acceleration in position, and by as much through its velocity;
/// - contact: a change of velocity is late by up to the lag of an impact, or by the h/2 of first order;
/// - skin and slop: of every body in a row of contacts or joints;
/// - creep, and impacts below the restitution threshold, times the time since;
/// - what the iterations leave of a change of velocity (see `unsolved`), times the time since.
double method_error(const Stepping&, const Stress&, bool bounces);

}  // namespace plumb
