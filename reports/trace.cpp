#include "reports/trace.h"

#include <algorithm>
#include <stdexcept>

#include "reports/system/hash.h"
#include "scenarios/scene/vec.h"

namespace plumb {

void Trace::reserve(std::size_t moments) {
  constexpr std::size_t most_states = 1'000'000;  // 48 MB: a long run may end early
  moments = std::min(moments, most_states / std::max<std::size_t>(bodies_, 1));
  times_.reserve(moments);
  states_.reserve(moments * bodies_);
  contact_end_.reserve(moments);
}

void Trace::record(double time, std::span<const BodyState> states, std::span<const ContactState> contacts) {
  if (states.size() != bodies_) throw std::invalid_argument("a trace needs the state of every body");
  if (!times_.empty() && !(time > times_.back())) throw std::invalid_argument("a trace needs increasing times");
  times_.push_back(time);
  states_.insert(states_.end(), states.begin(), states.end());
  contacts_.insert(contacts_.end(), contacts.begin(), contacts.end());
  contact_end_.push_back(contacts_.size());
}

std::span<const BodyState> Trace::states(std::size_t moment) const {
  return std::span(states_).subspan(moment * bodies_, bodies_);
}

std::span<const ContactState> Trace::contacts(std::size_t moment) const {
  const std::size_t begin = moment == 0 ? 0 : contact_end_[moment - 1];
  return std::span(contacts_).subspan(begin, contact_end_[moment] - begin);
}

Trace::Bracket Trace::bracket(double time) const {
  if (times_.empty()) throw std::invalid_argument("an empty trace has no states");
  const auto after = std::lower_bound(times_.begin(), times_.end(), time);
  if (after == times_.begin()) return {0, 0, 0};
  if (after == times_.end()) return {times_.size() - 1, times_.size() - 1, 0};
  const auto i = static_cast<std::size_t>(after - times_.begin());
  return {i - 1, i, (time - times_[i - 1]) / (times_[i] - times_[i - 1])};
}

BodyState Trace::state_at(std::size_t body, double time) const {
  const auto [before, after, fraction] = bracket(time);
  const BodyState& a = states(before)[body];
  const BodyState& b = states(after)[body];
  return {.position = a.position + fraction * (b.position - a.position),
          .angle = a.angle + fraction * (b.angle - a.angle),
          .velocity = a.velocity + fraction * (b.velocity - a.velocity),
          .angular_velocity = a.angular_velocity + fraction * (b.angular_velocity - a.angular_velocity)};
}

std::uint64_t hash_of(const Trace& trace) {
  BitHash hash;
  const auto add = [&hash](Vec v) {
    hash.add(v.x);
    hash.add(v.y);
  };
  for (std::size_t i = 0; i < trace.size(); ++i) {
    hash.add(trace.time(i));
    for (const BodyState& state : trace.states(i)) {
      add(state.position);
      hash.add(state.angle);
      add(state.velocity);
      hash.add(state.angular_velocity);
    }
    for (const ContactState& contact : trace.contacts(i)) {
      hash.add(static_cast<std::uint64_t>(contact.a));
      hash.add(static_cast<std::uint64_t>(contact.b));
      add(contact.point);
      add(contact.normal);
      hash.add(contact.normal_impulse);
      hash.add(contact.tangent_impulse);
      hash.add(contact.separation);
    }
  }
  return hash.value();
}

}  // namespace plumb
