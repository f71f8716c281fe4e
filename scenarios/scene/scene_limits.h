#pragma once

#include "scenarios/scene/json_reader.h"

/// What a scene file may hold. A run counts as lost beyond 1e7 m and 1e6 m/s: a scene starts well inside. The other
/// ends keep masses, inertias and forces within what single precision holds, so that every engine can be asked.
namespace plumb::limits {

constexpr Range coordinate{-1e6, 1e6, "m"};
constexpr Range size{1e-6, 1e6, "m"};
constexpr Range length{0, 1e6, "m"};
constexpr Range angle{-1e6, 1e6, "rad"};
constexpr Range speed{-1e5, 1e5, "m/s"};
constexpr Range spin{-1e5, 1e5, "rad/s"};
constexpr Range acceleration{-1e6, 1e6, "m/s^2"};
constexpr Range density{0, 1e9, "kg/m^2"};
constexpr Range friction{0, 1e6, ""};
constexpr Range restitution{0, 1, ""};
constexpr Range damping{0, 1e6, "1/s"};
constexpr Range factor{-1e6, 1e6, ""};
constexpr Range stiffness{0, 1e12, "N/m"};
constexpr Range resistance{0, 1e12, "N s/m"};
constexpr Range force{-1e12, 1e12, "N"};
constexpr Range torque{-1e12, 1e12, "N m"};
constexpr Range strength{-1e12, 1e12, ""};
constexpr Range exponent{-10, 10, ""};
constexpr Range duration{1e-6, 3600, "s"};
constexpr Range layers{0, 4294967295.0, ""};
constexpr Range reading{-1e30, 1e30, ""};
constexpr Range tolerance{0, 1e30, ""};

constexpr std::size_t name = 200;  // bytes
constexpr std::size_t text = 2000;

}  // namespace plumb::limits
