#include "reports/find/edit.h"

#include <optional>
#include <type_traits>
#include <variant>

namespace plumb {

Scene without_bodies(const Scene& scene, std::size_t begin, std::size_t end) {
  const auto gone = [&](std::size_t body) { return body >= begin && body < end; };
  const auto moved = [&](std::size_t body) { return body < begin ? body : body - (end - begin); };
  Scene rest = scene;
  rest.bodies.erase(rest.bodies.begin() + static_cast<std::ptrdiff_t>(begin),
                    rest.bodies.begin() + static_cast<std::ptrdiff_t>(end));
  rest.joints.clear();
  for (Joint joint : scene.joints) {
    const bool lost = std::visit([&](const auto& one) { return gone(one.a) || gone(one.b); }, joint);
    if (lost) continue;
    std::visit(
        [&](auto& one) {
          one.a = moved(one.a);
          one.b = moved(one.b);
        },
        joint);
    rest.joints.push_back(joint);
  }
  rest.forces.clear();
  for (Force force : scene.forces) {
    const bool lost = std::visit(
        [&](auto& one) {
          using Tie = std::decay_t<decltype(one)>;
          if constexpr (std::is_same_v<Tie, Attraction>) {
            const bool without = gone(one.from);
            one.from = moved(one.from);
            return without;
          } else if constexpr (std::is_same_v<Tie, Spring>) {
            const bool without = gone(one.b) || (one.a && gone(*one.a));
            one.b = moved(one.b);
            if (one.a) one.a = moved(*one.a);
            return without;
          } else {
            const bool without = gone(one.body);
            one.body = moved(one.body);
            return without;
          }
        },
        force);
    if (!lost) rest.forces.push_back(force);
  }
  return rest;
}

}  // namespace plumb
