// Controls that move rightly, and report it late or in part.

#include <algorithm>
#include <vector>

#include "reference/controls/control.h"

namespace plumb::readout_controls {
namespace {

class Silent : public Simulation {
 public:
  Silent(const Scene& scene, const Settings& settings) : ours_(build_ours(scene, settings)) {}
  void step(double dt) override { ours_->step(dt); }
  void read(std::span<BodyState> out) const override { ours_->read(out); }

 private:
  std::unique_ptr<Simulation> ours_;
};

class Late : public Simulation {
 public:
  Late(const Scene& scene, const Settings& settings)
      : ours_(build_ours(scene, settings)), states_(scene.bodies.size()) {
    ours_->read(states_);
  }
  void step(double dt) override {
    ours_->read(states_);
    contacts_.clear();
    ours_->read_contacts(contacts_);
    ours_->step(dt);
  }
  void read(std::span<BodyState> out) const override { std::copy(states_.begin(), states_.end(), out.begin()); }
  void read_contacts(std::vector<ContactState>& out) const override {
    out.insert(out.end(), contacts_.begin(), contacts_.end());
  }

 private:
  std::unique_ptr<Simulation> ours_;
  std::vector<BodyState> states_;
  std::vector<ContactState> contacts_;
};

const Catalog<Control>::Entry silent{simulated_by<Silent>("no-contacts", "moves rightly, and reports no contacts")};
const Catalog<Control>::Entry late{simulated_by<Late>("late", "shows every state and its contacts one step late")};

}  // namespace
}  // namespace plumb::readout_controls
