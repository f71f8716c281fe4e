// Faults of the reading: our engine is right, and what it shows is not.

#include <cmath>
#include <utility>

#include "reference/faults/fault.h"
#include "scenarios/scene/mass.h"

namespace plumb {
namespace {

using Misread = std::function<void(const Scene&, std::span<BodyState>)>;
using MisreadContact = std::function<void(ContactState&)>;

/// Steps as ours does; what is read goes through the hands of the fault.
class Misreading : public Simulation {
 public:
  Misreading(const Scene& scene, const Settings& settings, Misread states, MisreadContact contact)
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
  Misread states_;
  MisreadContact contact_;
};

Fault read_wrongly(std::string name, std::string about, const Misread& states,
                   const MisreadContact& contact = nullptr) {
  return {
      .name = std::move(name), .about = std::move(about), .build = [=](const Scene& scene, const Settings& settings) {
        return std::make_unique<Misreading>(scene, settings, states, contact);
      }};
}

const Catalog<Fault>::Entry origin{read_wrongly("origin-for-centre",
                                                "the place of the body's frame shown for that of its centre of mass",
                                                [](const Scene& scene, std::span<BodyState> states) {
                                                  for (std::size_t i = 0; i < states.size(); ++i) {
                                                    const Vec centre = mass_of(scene.bodies[i]).center;
                                                    const double c = std::cos(states[i].angle);
                                                    const double s = std::sin(states[i].angle);
                                                    states[i].position.x -= c * centre.x - s * centre.y;
                                                    states[i].position.y -= s * centre.x + c * centre.y;
                                                  }
                                                })};

const Catalog<Fault>::Entry normal_shown{
    read_wrongly("normal-shown-reversed", "contacts show the normal from b to a", nullptr, [](ContactState& contact) {
      contact.normal.x = -contact.normal.x;
      contact.normal.y = -contact.normal.y;
    })};

const Catalog<Fault>::Entry friction_shown{
    read_wrongly("friction-shown-reversed", "contacts show friction with the other sign", nullptr,
                 [](ContactState& contact) { contact.tangent_impulse = -contact.tangent_impulse; })};

const Catalog<Fault>::Entry impulse_shown{read_wrongly("impulse-of-substep",
                                                       "contacts show the impulse of the last of four sub-steps alone",
                                                       nullptr, [](ContactState& contact) {
                                                         contact.normal_impulse /= 4;
                                                         contact.tangent_impulse /= 4;
                                                       })};

}  // namespace
}  // namespace plumb
