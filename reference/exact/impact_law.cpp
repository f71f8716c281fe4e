#include "reference/exact/impact_law.h"

#include <algorithm>
#include <cmath>

namespace plumb {

// An impulse P at the arm r changes the point's velocity by
//   du_n = K_nn P_n + K_nt P_t,   K_nn = 1/m + (r x n)^2/I,   K_nt = (r x n)(r x t)/I,
//   du_t = K_nt P_n + K_tt P_t,   K_tt = 1/m + (r x t)^2/I.
// While the point slips one way, s = sign(u_t), P_t = -s mu P_n all along, so both speeds are linear in P_n and every
// law of restitution ends at u_n' = -e u_n: P_n = -(1 + e) u_n/(K_nn - s mu K_nt). If K_nt = 0 the two directions do
// not know of each other, and slip that stops just stays stopped: P_t = -u_t/K_tt. Source: Brach, Mechanical Impact
// Dynamics (1991); Stronge, Impact Mechanics (2000), ch. 3.
std::optional<Vec> impulse(const Meeting& meeting) {
  const Vec n = meeting.normal;
  const Vec t{n.y, -n.x};
  const Vec u = meeting.velocity + meeting.spin * left_of(meeting.arm);
  const double un = dot(u, n);
  const double ut = dot(u, t);
  if (un >= 0) return std::nullopt;
  const double lever_n = cross(meeting.arm, n);
  const double lever_t = cross(meeting.arm, t);
  const double knn = 1 / meeting.mass + lever_n * lever_n / meeting.inertia;
  const double ktt = 1 / meeting.mass + lever_t * lever_t / meeting.inertia;
  const double knt = lever_n * lever_t / meeting.inertia;
  const double bounce = -(1 + meeting.restitution) * un;
  const double mu = meeting.friction;
  if (mu == 0) return bounce / knn * n;
  constexpr double coupled = 1e-12;  // K_nt below that share of K_nn is round-off of the arm
  if (std::abs(knt) <= coupled * knn) {
    const double pn = bounce / knn;
    return pn * n + std::clamp(-ut / ktt, -mu * pn, mu * pn) * t;
  }
  const double s = ut > 0 ? 1 : -1;
  const double stiff = knn - s * mu * knt;
  if (ut == 0 || stiff <= 0) return std::nullopt;
  const double pn = bounce / stiff;
  if (s * (ut + (knt - s * mu * ktt) * pn) < 0) return std::nullopt;
  return pn * n - s * mu * pn * t;
}

}  // namespace plumb
