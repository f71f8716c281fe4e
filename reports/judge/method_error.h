#pragma once

#include <cstddef>
#include <vector>

#include "reports/trace.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/scene.h"

/// The position error that a method makes by itself along a known motion, before the scene amplifies it. From the
/// motion and what the method states alone, never from a run of the method.
namespace plumb {

/// m/s, by moment and body, rim included: the changes of velocity in jams, impacts without a collision (Painleve;
/// Lecornu). In a jam touching bodies that nothing approaches change their velocities at once, because friction turns
/// the contact under the body. A step counts if it changes the velocity by more than twice what gravity does, by what
/// neither the step before nor the one after does.
std::vector<std::vector<double>> jams_in(const Scene&, const Trace&);

/// How a motion stresses methods, up to one of its moments: the largest over all dynamic bodies. Speeds include those
/// of the rim.
struct Stress {
  double smooth = 0;   // m/s, the sum of all changes of velocity while nothing pushed the body
  double bends = 0;    // m/s^2, the sum of all changes of acceleration, from before to after a contact begins or ends
  double jolts = 0;    // m/s^3, the same of its rate of change
  double strays = 0;   // m/s^2, the sum of its rates of change at the start and after a contact begins or ends, each
                       // times the time since
  double pushed = 0;   // m/s, the sum of all changes of velocity by contacts
  double carried = 0;  // m, the sum of all changes of velocity, and of gravity's that contacts and joints take away,
                       // each times the time since
  double jammed = 0;   // m/s, the sum of all changes of velocity in jams (see jams_in), but for the first step's
  double turned = 0;  // m/s, the sum of all changes in jams, each times its body's rotation in rad/s and the time since
  double slowest = 0;  // m/s, the smallest change of velocity at an impact; 0: none
  double touched = 0;  // s, since the first contact
  int contacts = 0;    // in a row, at most: from a fixed body, or across a group that touches none
  int joints = 0;      // the same
};

/// One per moment of a trace that reports contacts.
std::vector<Stress> stress_along(const Scene&, const Trace&);

struct MethodError {
  double place = 0;  // m
  double speed = 0;  // m/s
};

/// The largest errors of a method in such a motion. Its place is off by the sum of
/// - a method of first order applies each change of velocity too early or too late by up to h/2 (the free fall of
///   symplectic Euler, g t h/2, is such a sum), or as its drift states; one of second order is off by h^2/6 times the
///   changes of acceleration in position, and by as much through its velocity. That is off by h^2/12 times what the
///   rate of change of acceleration has become less than it was at first (the trapezoidal rule), so that what flies on
///   after a force has ceased goes on to stray: h^2/12 times that first rate and the time since;
/// - contact: a change of velocity is late by up to the lag of an impact, or by the h/2 of first order;
/// - jams: nothing approaches, so their time is not solved for even by a method that solves for times of impact. One
///   begins at a step, up to dt late but for the first, and its contact keeps the normal and arms found there, which
///   turn by w dt in the step: so much of the change of velocity has the wrong direction, for the time since;
/// - skin and slop, at every contact or joint in a row;
/// - creep, and impacts below the restitution threshold, times the time since;
/// - what the iterations leave of a change of velocity (see `unsolved`), times the time since.
/// Its speed is off by h/2 times the changes of acceleration at first order (the rectangle rule), by h^2/6 times the
/// changes of their rate at second, and by the restitution threshold if an impact is below it.
MethodError method_error(const Stepping&, const Stress&, bool bounces);

}  // namespace plumb
