#include "reports/judge/contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

// m, the smallest radius of a body's round shapes; nullopt if it has none.
std::optional<double> smallest_radius(const Body& body) {
  std::optional<double> radius;
  for (const Shape& shape : body.shapes) {
    const auto* circle = std::get_if<Circle>(&shape.geometry);
    const auto* capsule = std::get_if<Capsule>(&shape.geometry);
    if (circle == nullptr && capsule == nullptr) continue;
    radius = std::min(radius.value_or(std::numeric_limits<double>::infinity()),
                      circle != nullptr ? circle->radius : capsule->radius);
  }
  return radius;
}

bool is_flat(const Body& body) {
  return std::all_of(body.shapes.begin(), body.shapes.end(),
                     [](const Shape& shape) { return std::holds_alternative<HalfSpace>(shape.geometry); });
}

}  // namespace

Vec velocity_at(const BodyState& state, Vec point) {
  const Vec arm = point - state.position;
  return state.velocity + state.angular_velocity * Vec{-arm.y, arm.x};
}

Vec relative_velocity(const ContactState& contact, std::span<const BodyState> states) {
  return velocity_at(states[contact.b], contact.point) - velocity_at(states[contact.a], contact.point);
}

Vec velocity_before(const Scene& scene, const ContactState& contact, std::span<const BodyState> then,
                    std::span<const BodyState> now) {
  const auto at_contact = [&](std::size_t body) {
    const double turned = smallest_radius(scene.bodies[body]) ? 0 : now[body].angle - then[body].angle;
    const Vec arm = rotated(contact.point - now[body].position, -turned);
    return velocity_at(then[body], then[body].position + arm);
  };
  return at_contact(contact.b) - at_contact(contact.a);
}

Vec impulse_of(const ContactState& contact) {
  const Vec tangent{-contact.normal.y, contact.normal.x};
  return contact.normal_impulse * contact.normal + contact.tangent_impulse * tangent;
}

double normal_rotation(const Scene& scene, const ContactState& contact, std::span<const BodyState> states, double dt) {
  const BodyState& a = states[contact.a];
  const BodyState& b = states[contact.b];
  const double turned = dt * (std::abs(a.angular_velocity) + std::abs(b.angular_velocity));
  if (is_flat(scene.bodies[contact.a]) || is_flat(scene.bodies[contact.b])) return turned;
  const auto of_a = smallest_radius(scene.bodies[contact.a]);
  const auto of_b = smallest_radius(scene.bodies[contact.b]);
  if (!of_a && !of_b) return turned;
  return turned + dt * length(b.velocity - a.velocity) / (of_a.value_or(0) + of_b.value_or(0));
}

bool PairContacts::acts(double slack) const { return normal_impulse > 0 || separation() < -slack; }

double PairContacts::separation() const {
  return std::min_element(points.begin(), points.end(),
                          [](const auto& one, const auto& other) { return one.separation < other.separation; })
      ->separation;
}

ContactsByPair contacts_by_pair(std::span<const ContactState> contacts) {
  ContactsByPair pairs;
  for (ContactState contact : contacts) {
    if (contact.a > contact.b) {
      // Swapping the bodies flips the impulses and both directions, so their products stay.
      std::swap(contact.a, contact.b);
      contact.normal = -1 * contact.normal;
    }
    PairContacts& pair = pairs[{contact.a, contact.b}];
    pair.normal_impulse += contact.normal_impulse;
    pair.tangent_impulse += contact.tangent_impulse;
    pair.points.push_back(contact);
  }
  return pairs;
}

std::string pair_name(const Scene& scene, std::size_t a, std::size_t b) {
  return scene.bodies[a].name + " - " + scene.bodies[b].name;
}

double impulse_change(std::span<const ContactState> before, const ContactState& now) {
  double impulse = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (const ContactState& then : before) {
    if (then.a != now.a || then.b != now.b) continue;
    const double distance = length(then.point - now.point);
    if (!(distance < nearest)) continue;
    nearest = distance;
    impulse = then.normal_impulse;
  }
  return std::abs(now.normal_impulse - impulse);
}

// If each iteration multiplies the error by r, iteration n + 1 changes it by (1 - r) r^n, which is largest for
// r = n/(n + 1), whatever r the scene gives.
double unsolved_share(const Stepping& stepping) {
  if (stepping.iterations == 0) return 0;
  const double n = stepping.iterations;
  return std::pow(n / (n + 1), n) / (n + 1);
}

// A first-order method may use the normal impulse of the step before. A method that iterates n times over all contacts
// uses that of the iteration before, which is off by the unsolved share of the step's change, the initial error.
std::vector<double> stale_impulse_error(std::span<const ContactState> before, std::span<const ContactState> now,
                                        const Stepping& stepping) {
  std::vector<double> errors(now.size());
  if (stepping.drift == 0 || now.empty()) return errors;
  const auto of_earlier_pair = [](const ContactState& one, const ContactState& other) {
    return std::pair(one.a, one.b) < std::pair(other.a, other.b);
  };
  std::vector<ContactState> by_pair(before.begin(), before.end());
  std::stable_sort(by_pair.begin(), by_pair.end(), of_earlier_pair);
  std::transform(now.begin(), now.end(), errors.begin(), [&](const ContactState& contact) {
    const auto [first, last] = std::equal_range(by_pair.begin(), by_pair.end(), contact, of_earlier_pair);
    return impulse_change({first, last}, contact);
  });
  if (stepping.iterations == 0) return errors;
  const double iterated = unsolved_share(stepping) * *std::max_element(errors.begin(), errors.end());
  for (double& one : errors) one = std::max(one, iterated);
  return errors;
}

RestitutionBounds restitution_between(const Scene& scene, std::size_t a, std::size_t b) {
  RestitutionBounds bounds{1, 0};
  for (const Shape& one : scene.bodies[a].shapes) {
    for (const Shape& other : scene.bodies[b].shapes) {
      const double e = mixed_restitution(scene.mixing, one.surface, other.surface);
      bounds = {std::min(bounds.smallest, e), std::max(bounds.largest, e)};
    }
  }
  return bounds;
}

double FrictionBounds::largest_static(std::size_t a, std::size_t b) const {
  double largest = 0;
  for (const Shape& one : scene_.bodies[a].shapes) {
    for (const Shape& other : scene_.bodies[b].shapes) {
      largest = std::max(largest, mixed_static_friction(scene_.mixing, one.surface, other.surface));
    }
  }
  return largest;
}

double FrictionBounds::smallest_dynamic(std::size_t a, std::size_t b) const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Shape& one : scene_.bodies[a].shapes) {
    for (const Shape& other : scene_.bodies[b].shapes) {
      smallest = std::min(smallest, mixed_dynamic_friction(scene_.mixing, one.surface, other.surface));
    }
  }
  return smallest;
}

}  // namespace plumb
