#pragma once

/// The whole engine API.
#include "impulse/body.h"
#include "impulse/clock.h"
#include "impulse/contact.h"
#include "impulse/debug_draw.h"
#include "impulse/force.h"
#include "impulse/joint.h"
#include "impulse/material.h"
#include "impulse/math.h"
#include "impulse/settings.h"
#include "impulse/shape.h"
#include "impulse/world.h"
