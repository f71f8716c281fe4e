#include <optional>

#include "c_api/convert.h"

namespace impulse::c_api {

namespace {

/// The list of one kind of events.
template <class Item>
std::span<const Item> chosen(impulse_events which, std::span<const Item> begun, std::span<const Item> lasting,
                             std::span<const Item> ended) {
  switch (which) {
    case IMPULSE_BEGUN:
      return begun;
    case IMPULSE_LASTING:
      return lasting;
    case IMPULSE_ENDED:
      return ended;
  }
  throw std::invalid_argument("the kind of events is unknown");
}

impulse_contact to_c(const ContactInfo& from) {
  return {c_api::to_c(from.a), c_api::to_c(from.b), c_api::to_c(from.point), c_api::to_c(from.normal),
          from.separation,     from.normal_impulse, from.tangent_impulse};
}

impulse_touch to_c(const TouchingParts& from) {
  return {c_api::to_c(PartId{from.a, from.part_a}),
          c_api::to_c(PartId{from.b, from.part_b}),
          c_api::to_c(from.point),
          c_api::to_c(from.normal),
          from.normal_impulse,
          from.tangent_impulse};
}

impulse_overlap to_c(const SensorOverlap& from) { return {c_api::to_c(from.sensor), c_api::to_c(from.visitor)}; }

impulse_hit to_c(const std::optional<BodyHit>& from) {
  if (!from) return {};
  return {
      true, {c_api::to_c(from->body), from->part}, from->fraction, c_api::to_c(from->point), c_api::to_c(from->normal)};
}

}  // namespace

}  // namespace impulse::c_api

using namespace impulse::c_api;

impulse_status impulse_contacts(const impulse_world* world, impulse_contact* into, size_t capacity, size_t* count) {
  return guarded([&] {
    list(world_of(world).contacts(), into, capacity, count,
         [](const impulse::ContactInfo& contact) { return to_c(contact); });
  });
}

impulse_status impulse_contact_events(const impulse_world* world, impulse_events which, impulse_touch* into,
                                      size_t capacity, size_t* count) {
  return guarded([&] {
    const impulse::ContactEvents events = world_of(world).contact_events();
    list(chosen(which, events.begun, events.touching, events.ended), into, capacity, count,
         [](const impulse::TouchingParts& parts) { return to_c(parts); });
  });
}

impulse_status impulse_sensor_events(const impulse_world* world, impulse_events which, impulse_overlap* into,
                                     size_t capacity, size_t* count) {
  return guarded([&] {
    const impulse::SensorEvents events = world_of(world).sensor_events();
    list(chosen(which, events.begun, events.overlapping, events.ended), into, capacity, count,
         [](const impulse::SensorOverlap& overlap) { return to_c(overlap); });
  });
}

impulse_status impulse_ray_cast(const impulse_world* world, impulse_vec2 from, impulse_vec2 to, uint32_t layers,
                                impulse_hit* hit) {
  return guarded(
      [&] { given(hit, "the place for the hit") = to_c(world_of(world).ray_cast(from_c(from), from_c(to), layers)); });
}

impulse_status impulse_shape_cast(const impulse_world* world, const impulse_shape* shape, impulse_vec2 position,
                                  float angle, impulse_vec2 by, uint32_t layers, impulse_hit* hit) {
  return guarded([&] {
    const impulse::Pose start{from_c(position), impulse::Rotation(angle)};
    given(hit, "the place for the hit") =
        to_c(world_of(world).shape_cast(shape_from_c(given(shape, "the shape")), start, from_c(by), layers));
  });
}
