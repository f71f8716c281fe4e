#pragma once

#include "scenarios/scene/json_reader.h"
#include "scenarios/scene/scene.h"

namespace plumb {

/// One of a body's shapes, with its surface.
Shape read_shape(const JsonReader&);

}  // namespace plumb
