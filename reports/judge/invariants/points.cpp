// A contact point is reported once.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <variant>
#include <vector>

#include "reports/judge/contacts.h"
#include "reports/judge/invariant.h"
#include "reports/judge/rounding.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/scene.h"
#include "scenarios/scene/vec.h"

namespace plumb::invariants::points {
namespace {

// Whether contacts of a body have at most two points, and a disc's one, in any engine: a body of several shapes may
// share a corner among them, and engines make capsules of several.
bool convex(const Body& body) {
  return body.shapes.size() == 1 && !std::holds_alternative<Capsule>(body.shapes.front().geometry);
}

bool round(const Body& body) { return std::holds_alternative<Circle>(body.shapes.front().geometry); }

bool same_point(const ContactState& a, const ContactState& b, double nu) {
  return length(a.point - b.point) <= nu * length(a.point) && length(a.normal - b.normal) <= nu;
}

// N s, of each point that a pair reports more than once: the smaller of the impulses reported there.
std::vector<double> reported_again(std::span<const ContactState> points, double nu) {
  std::vector<double> again;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = i + 1; k < points.size(); ++k) {
      if (!same_point(points[i], points[k], nu)) continue;
      again.push_back(std::min(points[i].normal_impulse, points[k].normal_impulse));
    }
  }
  return again;
}

// Two convex shapes that meet push at each point once. A pair that an engine has found twice is pushed by two contacts
// at the same points, which share a load: bodies move as they should, but events and sensors of force count them, a
// solver that iterates converges more slowly, and each costs its time. A contact that shrinks to a point, as a corner
// passes an edge's end, has both of its points there: one point that is reported twice tells only of discs. Points are
// the same if they differ by rounding. A report is no motion, so this is never evidence of physics.
std::optional<InvariantCheck> check(const InvariantContext& context) {
  if (auto cannot = without_contacts(context, false)) return cannot;
  const double nu = solver_rounding(context.stepping);
  WorstViolation worst;
  for (std::size_t moment = 0; moment < context.trace.size(); ++moment) {
    for (const auto& [pair, contact] : contacts_by_pair(context.trace.contacts(moment))) {
      const Body& a = context.scene.bodies[pair.first];
      const Body& b = context.scene.bodies[pair.second];
      if (!convex(a) || !convex(b)) continue;
      std::vector<double> again = reported_again(contact.points, nu);
      std::sort(again.begin(), again.end(), std::greater<>());
      const std::size_t may_be = round(a) || round(b) ? 0 : 1;
      if (again.size() <= may_be) continue;
      worst.add(again[may_be], nu * contact.normal_impulse, 0, context.trace.time(moment),
                [&] { return a.name + " - " + b.name; });
    }
  }
  return worst.result();
}

const Catalog<Invariant>::Entry entry{
    {.name = "points",
     .unit = "N s",
     .definition =
         "each contact point is reported once: the smaller of two normal impulses at a disc's one point, or at each "
         "of the two points of other convex shapes",
     .check = check}};

}  // namespace
}  // namespace plumb::invariants::points
