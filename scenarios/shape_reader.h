#pragma once

#include "scenarios/json_reader.h"
#include "scenarios/scene.h"

namespace plumb {

/// One of a body's shapes, with its surface.
Shape read_shape(const JsonReader&);

}  // namespace plumb
