#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <span>
#include <stdexcept>

#include "impulse.h"
#include "impulse/impulse.h"

/// What all calls of the C API share.
struct impulse_world {
  impulse::World world;
};

namespace impulse::c_api {

impulse_status failed(impulse_status status, const char* what) noexcept;
/// The status and message of the exception that is being handled.
impulse_status failed() noexcept;

/// Runs a call, and turns an exception into its status.
template <class Call>
impulse_status guarded(const Call& call) noexcept {
  try {
    call();
    return IMPULSE_OK;
  } catch (...) {
    return failed();
  }
}

template <class T>
T& given(T* pointer, const char* what) {
  if (pointer == nullptr) throw std::invalid_argument(std::string(what) + " is NULL");
  return *pointer;
}
inline World& world_of(impulse_world* world) { return given(world, "the world").world; }
inline const World& world_of(const impulse_world* world) { return given(world, "the world").world; }

/// Copies as many items as there is room for, and counts them all.
template <class Item, class To, class Convert>
void list(std::span<const Item> items, To* into, std::size_t capacity, std::size_t* count, const Convert& convert) {
  given(count, "the count") = items.size();
  const std::size_t copied = std::min(items.size(), capacity);
  if (copied > 0) given(into, "the list");
  std::transform(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(copied), into, convert);
}

inline Vec2 from_c(impulse_vec2 v) { return {v.x, v.y}; }
inline BodyId from_c(impulse_body_id id) { return {id.index, id.generation}; }
inline JointId from_c(impulse_joint_id id) { return {id.index, id.generation}; }
inline Layers from_c(impulse_layers layers) { return {layers.category, layers.mask}; }
inline Material from_c(const impulse_material& m) {
  return {m.density, m.static_friction, m.dynamic_friction, m.restitution};
}
Shape shape_from_c(const impulse_shape& shape);

inline impulse_vec2 to_c(Vec2 v) { return {v.x, v.y}; }
inline impulse_body_id to_c(BodyId id) { return {id.index, id.generation}; }
inline impulse_joint_id to_c(JointId id) { return {id.index, id.generation}; }
inline impulse_layers to_c(Layers layers) { return {layers.category, layers.mask}; }
inline impulse_part_id to_c(PartId id) { return {to_c(id.body), id.part}; }

}  // namespace impulse::c_api
