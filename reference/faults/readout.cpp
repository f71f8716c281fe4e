// Faults of the readout: our engine is right, but its states and contacts are reported wrongly.

#include <cmath>
#include <utility>

#include "reference/faults/altered_engine.h"
#include "scenarios/scene/mass.h"

namespace plumb::readout_faults {
namespace {

using AlterStates = std::function<void(const Scene&, std::span<BodyState>)>;
using AlterContact = std::function<void(ContactState&)>;

/// Steps like our engine, but alters what is read.
class AlteredReadout : public Simulation {
 public:
  AlteredReadout(const Scene& scene, const Settings& settings, AlterStates states, AlterContact contact)
      : scene_(scene), ours_(build_ours(scene, settings)), states_(std::move(states)), contact_(std::move(contact)) {}

  void step(double dt) override { ours_->step(dt); }
  void read(std::span<BodyState> out) const override {
    ours_->read(out);
    if (states_) states_(scene_, out);
  }
  void read_contacts(std::vector<ContactState>& out) const override {
    const std::size_t before = out.size();
    ours_->read_contacts(out);
    if (!contact_) return;
    for (std::size_t i = before; i < out.size(); ++i) contact_(out[i]);
  }

 private:
  Scene scene_;
  std::unique_ptr<Simulation> ours_;
  AlterStates states_;
  AlterContact contact_;
};

Fault with_altered_readout(std::string name, std::string about, const AlterStates& states,
                           const AlterContact& contact = nullptr) {
  return {
      .name = std::move(name), .about = std::move(about), .build = [=](const Scene& scene, const Settings& settings) {
        return std::make_unique<AlteredReadout>(scene, settings, states, contact);
      }};
}

const Catalog<Fault>::Entry origin{
    with_altered_readout("origin-for-centre", "reports the position of the body's origin as that of its centre of mass",
                         [](const Scene& scene, std::span<BodyState> states) {
                           for (std::size_t i = 0; i < states.size(); ++i) {
                             const Vec centre = mass_of(scene.bodies[i]).center;
                             const double c = std::cos(states[i].angle);
                             const double s = std::sin(states[i].angle);
                             states[i].position.x -= c * centre.x - s * centre.y;
                             states[i].position.y -= s * centre.x + c * centre.y;
                           }
                         })};

const Catalog<Fault>::Entry normal_shown{with_altered_readout(
    "normal-shown-reversed", "contacts report the normal from b to a", nullptr, [](ContactState& contact) {
      contact.normal.x = -contact.normal.x;
      contact.normal.y = -contact.normal.y;
    })};

const Catalog<Fault>::Entry friction_shown{
    with_altered_readout("friction-shown-reversed", "contacts report friction with the wrong sign", nullptr,
                         [](ContactState& contact) { contact.tangent_impulse = -contact.tangent_impulse; })};

const Catalog<Fault>::Entry impulse_shown{
    with_altered_readout("impulse-of-substep", "contacts report only the impulse of the last of four sub-steps",
                         nullptr, [](ContactState& contact) {
                           contact.normal_impulse /= 4;
                           contact.tangent_impulse /= 4;
                         })};

// Interpolation between steps (the article, part 2): our engine takes its own steps, and a readout is blended from the
// steps before and after it.

/// Returns previous at alpha = 0 and current at alpha = 1.
using Blend = std::function<double(double previous, double current, double alpha)>;

/// Runs our engine with steps that are longer than the requested ones by the golden ratio, so that readouts fall
/// everywhere between two steps. The engine runs ahead until the time of the readout lies between its last two.
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

BuildSimulation interpolated_by(const Blend& place, const Blend& turn) {
  return [=](const Scene& scene, const Settings& settings) {
    return std::make_unique<BetweenSteps>(scene, settings, place, turn);
  };
}

const Catalog<Fault>::Entry backwards{
    {.name = "interpolation-reversed",
     .about = "interpolates by previous * alpha + current * (1 - alpha), which runs backwards",
     .source = "the article, part 2: interpolated rendering",
     .build = interpolated_by(reversed, reversed),
     .right = interpolated_by(blended, blended)}};

const Catalog<Fault>::Entry angles_left_out{{.name = "interpolation-without-angles",
                                             .about = "interpolates positions between steps, but not angles",
                                             .source = "the article, part 2: interpolated rendering",
                                             .build = interpolated_by(blended, latest),
                                             .right = interpolated_by(blended, blended)}};

}  // namespace
}  // namespace plumb::readout_faults
