// Drawing between steps (the seed's row 6): our engine steps on its own grid, and what is read is blended from the two
// steps on either side of the moment.

#include <utility>

#include "reference/faults/fault.h"

namespace plumb {
namespace {

/// previous at 0, current at 1.
using Blend = std::function<double(double previous, double current, double alpha)>;

/// Steps of our engine are longer than those it is asked for by the golden ratio, so that the moments asked for fall
/// everywhere between two of them. It runs ahead until the moment lies between.
class BetweenSteps : public Simulation {
 public:
  BetweenSteps(const Scene& scene, const Settings& settings, Blend place, Blend turn)
      : ours_(build_ours(scene, settings)), place_(std::move(place)), turn_(std::move(turn)) {
    current_.resize(scene.bodies.size());
    ours_->read(current_);
    previous_ = current_;
  }

  void step(double dt) override {
    constexpr double golden = 1.6180339887498949;
    if (own_dt_ == 0) own_dt_ = golden * dt;
    now_ += dt;
    while (static_cast<double>(steps_) * own_dt_ < now_) {
      std::swap(previous_, current_);
      ours_->step(own_dt_);
      ours_->read(current_);
      ++steps_;
    }
  }

  void read(std::span<BodyState> out) const override {
    const double alpha = steps_ == 0 ? 1 : now_ / own_dt_ - static_cast<double>(steps_ - 1);
    for (std::size_t i = 0; i < out.size(); ++i) {
      const BodyState& a = previous_[i];
      const BodyState& b = current_[i];
      out[i] = {{place_(a.position.x, b.position.x, alpha), place_(a.position.y, b.position.y, alpha)},
                turn_(a.angle, b.angle, alpha),
                {place_(a.velocity.x, b.velocity.x, alpha), place_(a.velocity.y, b.velocity.y, alpha)},
                place_(a.angular_velocity, b.angular_velocity, alpha)};
    }
  }

 private:
  std::unique_ptr<Simulation> ours_;
  Blend place_, turn_;
  std::vector<BodyState> previous_, current_;
  double own_dt_ = 0, now_ = 0;
  long steps_ = 0;
};

double blended(double previous, double current, double alpha) { return previous * (1 - alpha) + current * alpha; }
double reversed(double previous, double current, double alpha) { return previous * alpha + current * (1 - alpha); }
double latest(double, double current, double) { return current; }

BuildSimulation drawn_by(const Blend& place, const Blend& turn) {
  return [=](const Scene& scene, const Settings& settings) {
    return std::make_unique<BetweenSteps>(scene, settings, place, turn);
  };
}

const Catalog<Fault>::Entry backwards{{.name = "interpolation-reversed",
                                       .about = "previous * alpha + current * (1 - alpha): drawing runs backwards",
                                       .source = "row 6",
                                       .build = drawn_by(reversed, reversed),
                                       .right = drawn_by(blended, blended)}};

const Catalog<Fault>::Entry angles_left_out{{.name = "interpolation-without-angles",
                                             .about = "places are blended between steps, angles are not",
                                             .source = "row 6",
                                             .build = drawn_by(blended, latest),
                                             .right = drawn_by(blended, blended)}};

}  // namespace
}  // namespace plumb
