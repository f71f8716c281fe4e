#include "reference/paths.h"

#include <utility>

#include "scenarios/scene/path.h"

namespace plumb {
namespace {

class OnPaths : public Simulation {
 public:
  OnPaths(const Scene& scene, std::unique_ptr<Simulation> inner) : inner_(std::move(inner)) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const Body& body = scene.bodies[i];
      if (!body.path) continue;
      carried_.push_back({i, body.velocity, *body.path});
      inner_->drive(i, start_velocity(body));
    }
  }

  void announce(double dt, std::size_t steps) override { inner_->announce(dt, steps); }

  void step(double dt) override {
    for (const Carried& body : carried_) {
      const Vec from = path_offset(body.path, time_);
      const Vec to = path_offset(body.path, time_ + dt);
      inner_->drive(body.index, {body.steady.x + (to.x - from.x) / dt, body.steady.y + (to.y - from.y) / dt});
    }
    inner_->step(dt);
    time_ += dt;
  }

  void read(std::span<BodyState> out) const override { inner_->read(out); }
  void read_contacts(std::vector<ContactState>& out) const override { inner_->read_contacts(out); }
  std::optional<double> seconds_stepped() const override { return inner_->seconds_stepped(); }
  double valid_until() const override { return inner_->valid_until(); }

 private:
  struct Carried {
    std::size_t index;
    Vec steady;  // m/s, the velocity beside the path's
    Path path;
  };

  std::unique_ptr<Simulation> inner_;
  std::vector<Carried> carried_;
  double time_ = 0;  // s
};

}  // namespace

std::unique_ptr<Simulation> on_paths(const Scene& scene, std::unique_ptr<Simulation> simulation) {
  if (!has_paths(scene)) return simulation;
  return std::make_unique<OnPaths>(scene, std::move(simulation));
}

}  // namespace plumb
