// Controls that show other states than those of a moving world: of bodies that stay where they start, all of them, the
// last one, or all until the end; late ones; or no contacts.

#include <algorithm>
#include <vector>

#include "reference/faults/altered_engine.h"
#include "reference/scene_facts.h"

namespace plumb::readouts {
namespace {

class Frozen : public Simulation {
 public:
  Frozen(const Scene& scene, const Settings&) : start_(start_of(scene)) {}
  void step(double) override {}
  void read(std::span<BodyState> out) const override { std::copy(start_.begin(), start_.end(), out.begin()); }

 private:
  std::vector<BodyState> start_;
};

class Stopped : public Frozen {
 public:
  using Frozen::Frozen;
  void read(std::span<BodyState> out) const override {
    Frozen::read(out);
    for (BodyState& state : out) {
      state.velocity = {};
      state.angular_velocity = 0;
    }
  }
};

class Teleporting : public Frozen {
 public:
  Teleporting(const Scene& scene, const Settings& settings)
      : Frozen(scene, settings), left_(scene.duration), ours_(build_ours(scene, settings)) {}
  void step(double dt) override {
    ours_->step(dt);
    left_ -= dt;
    shown_ = left_ < dt / 2;
  }
  void read(std::span<BodyState> out) const override {
    if (shown_) return ours_->read(out);
    Frozen::read(out);
  }
  void read_contacts(std::vector<ContactState>& out) const override {
    if (shown_) ours_->read_contacts(out);
  }

 private:
  double left_;  // s
  bool shown_ = false;
  std::unique_ptr<Simulation> ours_;
};

std::vector<Body>::const_iterator last_dynamic(const Scene& scene) {
  const auto found = std::find_if(scene.bodies.rbegin(), scene.bodies.rend(),
                                  [](const Body& body) { return body.type == BodyType::dynamic; });
  return found == scene.bodies.rend() ? scene.bodies.end() : std::prev(found.base());
}

class Forgetful : public Simulation {
 public:
  Forgetful(const Scene& scene, const Settings& settings)
      : forgotten_(static_cast<std::size_t>(last_dynamic(scene) - scene.bodies.begin())) {
    Scene others = scene;
    if (forgotten_ < others.bodies.size()) {
      start_ = start_of(scene.bodies[forgotten_]);
      others.bodies[forgotten_].type = BodyType::fixed;
      others.bodies[forgotten_].layers = 0;
    }
    ours_ = build_ours(others, settings);
  }
  void step(double dt) override { ours_->step(dt); }
  void read(std::span<BodyState> out) const override {
    ours_->read(out);
    if (forgotten_ < out.size()) out[forgotten_] = start_;
  }
  void read_contacts(std::vector<ContactState>& out) const override { ours_->read_contacts(out); }

 private:
  std::size_t forgotten_;
  BodyState start_;
  std::unique_ptr<Simulation> ours_;
};

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

const Catalog<Control>::Entry frozen{
    simulated_by<Frozen>("frozen", "nothing moves, every velocity stays that of the start, nothing touches")};
const Catalog<Control>::Entry stopped{
    simulated_by<Stopped>("stopped", "nothing moves, every velocity is zero, nothing touches")};
const Catalog<Control>::Entry teleporting{
    simulated_by<Teleporting>("teleporting", "stays at the start, and shows the right state after the last step")};
const Catalog<Control>::Entry forgetful{
    simulated_by<Forgetful>("forgetful", "leaves out the last body, which stays as it starts")};
const Catalog<Control>::Entry silent{simulated_by<Silent>("no-contacts", "moves rightly, and reports no contacts")};
const Catalog<Control>::Entry late{simulated_by<Late>("late", "shows every state and its contacts one step late")};

}  // namespace
}  // namespace plumb::readouts
