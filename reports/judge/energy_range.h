#pragma once

#include "reports/trace.h"
#include "scenarios/scene/scene.h"

namespace plumb {

/// The energy that a scene has to turn over, J: what errors of energy are measured by. The same for every engine, for
/// it comes from the scene and, where there is one, its closed form. It is the sum of the kinetic energy at the start,
/// of what springs and attractions hold there, and of what gravity would set free if all bodies sank from the top of
/// the arrangement to its bottom; or the largest kinetic energy of the closed form, if that is more.
double energy_range(const Scene&, const Trace* truth);

}  // namespace plumb
