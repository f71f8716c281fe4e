#include "reports/judge/jams.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "reference/scene_facts.h"
#include "reports/judge/contacts.h"
#include "reports/judge/groups.h"
#include "reports/judge/overlap.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

class Jams {
 public:
  Jams(const Scene& scene, const Trace& trace) : scene_(scene), trace_(trace) {
    for (const Body& body : scene.bodies) radii_.push_back(bounding_radius(body));
  }

  std::vector<double> at(std::size_t moment) const {
    std::vector<double> jams(radii_.size());
    if (moment == 0 || trace_.contacts(moment).empty()) return jams;
    const double fall = length(scene_.gravity) * (trace_.time(moment) - trace_.time(moment - 1));
    std::vector<bool> struck(radii_.size());  // by group
    std::vector<bool> touches(radii_.size());
    Groups groups(radii_.size());
    for_all_pairs(moment, [&](std::size_t a, std::size_t b) {
      if (moves(a) && moves(b)) groups.join(a, b);
    });
    for (const ContactState& contact : trace_.contacts(moment)) {
      touches[contact.a] = touches[contact.b] = true;
      const bool approaches = -dot(contact.normal, relative_velocity(contact, trace_.states(moment - 1))) > fall;
      if (approaches) struck[groups.of(moves(contact.a) ? contact.a : contact.b)] = true;
    }
    for (std::size_t i = 0; i < jams.size(); ++i) {
      if (!moves(i) || !touches[i] || struck[groups.of(i)]) continue;
      const double jump = change(moment, i) - std::max(change(moment - 1, i), change(moment + 1, i));
      if (jump > 2 * fall) jams[i] = jump;
    }
    return jams;
  }

 private:
  bool moves(std::size_t body) const { return scene_.bodies[body].type == BodyType::dynamic; }

  template <class Join>
  void for_all_pairs(std::size_t moment, Join join) const {
    for (const ContactState& contact : trace_.contacts(moment)) join(contact.a, contact.b);
    for (const Joint& joint : scene_.joints) std::visit([&](const auto& of) { join(of.a, of.b); }, joint);
  }

  // m/s, of a body's velocity and its rim's in the step to a moment; 0 if there is no such step.
  double change(std::size_t moment, std::size_t body) const {
    if (moment == 0 || moment >= trace_.size()) return 0;
    const BodyState& then = trace_.states(moment - 1)[body];
    const BodyState& now = trace_.states(moment)[body];
    return std::hypot(length(now.velocity - then.velocity),
                      radii_[body] * (now.angular_velocity - then.angular_velocity));
  }

  const Scene& scene_;
  const Trace& trace_;
  std::vector<double> radii_;  // m
};

}  // namespace

std::vector<std::vector<double>> jams_in(const Scene& scene, const Trace& trace) {
  const Jams jams(scene, trace);
  std::vector<std::vector<double>> all;
  for (std::size_t moment = 0; moment < trace.size(); ++moment) all.push_back(jams.at(moment));
  return all;
}

}  // namespace plumb
