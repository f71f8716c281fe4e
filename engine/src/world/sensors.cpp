#include "world/sensors.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "core/method_list.h"
#include "shapes/distance.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// The generations distinguish a body from an earlier one with the same index.
bool earlier(const SensorOverlap& left, const SensorOverlap& right) {
  const auto key = [](const SensorOverlap& overlap) {
    const PartId& s = overlap.sensor;
    const PartId& v = overlap.visitor;
    return std::tuple(s.body.index, s.part, v.body.index, v.part, s.body.generation, v.body.generation);
  };
  return key(left) < key(right);
}

}  // namespace

Sensors::Sensors() : broad_phase_(MethodList<BroadPhase>::make("auto")) {}

Sensors::Sensors(const Sensors& other) : Sensors() {
  begun_ = other.begun_;
  overlapping_ = other.overlapping_;
  ended_ = other.ended_;
}

void Sensors::update(const BodySet& bodies) {
  if (part_changes_ != bodies.part_changes) list(bodies);
  if (count_ == 0 && overlapping_.empty() && ended_.empty()) return;
  std::swap(overlapping_, last_);
  find_overlaps(bodies);
  begun_.clear();
  ended_.clear();
  std::set_difference(overlapping_.begin(), overlapping_.end(), last_.begin(), last_.end(), std::back_inserter(begun_),
                      earlier);
  std::set_difference(last_.begin(), last_.end(), overlapping_.begin(), overlapping_.end(), std::back_inserter(ended_),
                      earlier);
}

void Sensors::list(const BodySet& bodies) {
  part_changes_ = bodies.part_changes;
  proxies_.clear();
  count_ = 0;
  for (const BodyDetail& body : bodies.detail) {
    if (body.inserted) count_ += static_cast<std::size_t>(std::ranges::count_if(body.parts, &Part::sensor));
  }
  if (count_ == 0) return;
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    const BodyDetail& body = bodies.detail[i];
    for (std::size_t p = 0; body.inserted && p < body.parts.size(); ++p) {
      const Part& part = body.parts[p];
      proxies_.push_back({{}, {}, i, static_cast<std::uint16_t>(p), part.sensor, body.layers_of(part)});
    }
  }
}

void Sensors::find_overlaps(const BodySet& bodies) {
  overlapping_.clear();
  if (count_ == 0) return;
  const auto shape = [&](const Proxy& proxy) -> const Shape& {
    return bodies.detail[proxy.body].parts[proxy.part].shape;
  };
  for (Proxy& proxy : proxies_) proxy.bounds = shape(proxy).bounds(bodies.pose[proxy.body]);
  broad_phase_->find_pairs(proxies_, pairs_);
  for (const Pair& pair : pairs_) {
    const Proxy& first = proxies_[pair.first];
    const Proxy& second = proxies_[pair.second];
    if (first.moves && second.moves) continue;
    const Gap gap = distance(shape(first), bodies.pose[first.body], shape(second), bodies.pose[second.body]);
    if (gap.distance > 0) continue;
    const auto id = [&](const Proxy& proxy) { return PartId{bodies.id(proxy.body), proxy.part}; };
    overlapping_.push_back(first.moves ? SensorOverlap{id(first), id(second)} : SensorOverlap{id(second), id(first)});
  }
  std::sort(overlapping_.begin(), overlapping_.end(), earlier);
}

}  // namespace impulse::inline IMPULSE_PRECISION
