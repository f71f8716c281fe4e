// Errors in how our engine steps: the length of a step, and the inertia that its solver takes.

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <utility>

#include "reference/faults/altered_engine.h"

namespace plumb::stepping_perturbations {
namespace {

// Every step is longer by a factor than the harness believes.
class LongerSteps final : public Simulation {
 public:
  LongerSteps(std::unique_ptr<Simulation> of, double factor) : of_(std::move(of)), factor_(factor) {}
  void step(double dt) override { of_->step(factor_ * dt); }
  void read(std::span<BodyState> out) const override { of_->read(out); }
  void read_contacts(std::vector<ContactState>& out) const override { of_->read_contacts(out); }

 private:
  std::unique_ptr<Simulation> of_;
  double factor_;
};

const Catalog<Perturbation>::Entry time_step{
    {.name = "time step",
     .about = "the length of every step",
     .applies = [](const Scene&) { return true; },
     .build = [](const Scene& scene, const Settings& settings, double error) -> std::unique_ptr<Simulation> {
       return std::make_unique<LongerSteps>(build_ours(scene, settings), 1 + error);
     }}};

bool turns(const Body& body) { return body.type == BodyType::dynamic && !body.fixed_rotation; }

const Catalog<Perturbation>::Entry inertia{
    {.name = "inertia",
     .about = "the moment of inertia of every body, without its mass",
     .applies = [](const Scene& scene) { return std::any_of(scene.bodies.begin(), scene.bodies.end(), turns); },
     .build =
         [](const Scene& scene, Settings settings, double error) {
           std::ostringstream factor;
           factor << std::setprecision(17) << 1 + error;
           settings["solver"] = "scaled-inertia=" + factor.str();
           return build_ours(scene, settings);
         }}};

}  // namespace
}  // namespace plumb::stepping_perturbations
