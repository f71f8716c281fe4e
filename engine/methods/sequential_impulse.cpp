#include <algorithm>
#include <memory>

#include "core/method_list.h"
#include "methods/sequential_impulses.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

constexpr Real beta = static_cast<Real>(.2);  // of the error, taken away in a step

/// Sequential impulses with Baumgarte's stabilisation: a point that overlaps beyond the slop is made to part at
///
///   beta (overlap - slop) / dt,
///
/// so the same impulses that stop bodies also push them apart. Simple, but that velocity is energy: bodies that were
/// pushed into each other jump.
class SequentialImpulse : public SequentialImpulses {
 private:
  void push_apart(ImpulseRow& row, ContactFrame& frame) const override { push_apart_in_turn(row, frame); }

  Real steer(std::vector<ImpulseRow>& rows, Real dt) const override {
    for (ImpulseRow& row : rows) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
        const Real overlap = -row.points[i].separation - slop;
        row.rebound[i] = std::max(row.rebound[i], beta * overlap / dt);
      }
    }
    return beta;
  }
};

const MethodList<Solver>::Entry sequential_impulse_entry{
    {"sequential-impulse", "accumulated, warm-started impulses; overlap pushed apart by velocities (Baumgarte)",
     "E. Catto, Iterative Dynamics with Temporal Coherence (GDC 2005), Fast and Simple Physics using Sequential "
     "Impulses (GDC 2006), and Box2D-Lite"},
    [] { return std::make_unique<SequentialImpulse>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
