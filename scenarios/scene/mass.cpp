#include "scenarios/scene/mass.h"

#include "scenarios/scene/shapes.h"

namespace plumb {

Mass mass_of(const Body& body) {
  if (body.type != BodyType::dynamic) return {};
  Mass total;
  for (const Shape& shape : body.shapes) {
    const Area part = area_of(shape.geometry);
    const double mass = shape.surface.density * part.area;
    if (mass == 0) continue;
    // Each part adds its own inertia and, by the parallel-axis theorem, m1 m2/(m1 + m2) d^2 for its distance d from the
    // centre of the parts before it: sums of positive terms only, so that nothing cancels.
    const Vec apart{part.center.x - total.center.x, part.center.y - total.center.y};
    const double share = mass / (total.mass + mass);
    total.inertia +=
        shape.surface.density * part.second_moment + total.mass * share * (apart.x * apart.x + apart.y * apart.y);
    total.center = {total.center.x + share * apart.x, total.center.y + share * apart.y};
    total.mass += mass;
  }
  if (body.fixed_rotation) total.inertia = 0;
  return total;
}

}  // namespace plumb
