// Faults of the scene: our engine runs a scene that differs a little from the given one.

#include <utility>

#include "reference/faults/altered_engine.h"

namespace plumb::scene_faults {
namespace {

using Alteration = void (*)(Scene&);

Fault with_altered_scene(std::string name, std::string about, Alteration alter, std::string source = "") {
  return {.name = std::move(name),
          .about = std::move(about),
          .source = std::move(source),
          .build = [alter](Scene scene, const Settings& settings) {
            alter(scene);
            return build_ours(scene, settings);
          }};
}

template <class Change>
void each_body(Scene& scene, Change change) {
  for (Body& body : scene.bodies) change(body);
}

template <class Change>
void each_surface(Scene& scene, Change change) {
  for (Body& body : scene.bodies) {
    for (Shape& shape : body.shapes) change(shape.surface);
  }
}

template <class Kind, class Change>
void each_force(Scene& scene, Change change) {
  for (Force& force : scene.forces) {
    if (Kind* kind = std::get_if<Kind>(&force)) change(*kind);
  }
}

const Catalog<Fault>::Entry restitution_mixing{
    with_altered_scene("restitution-min-for-max",
                       "takes the smaller of two restitutions instead of the larger, and vice versa", [](Scene& scene) {
                         RestitutionMixing& rule = scene.mixing.restitution;
                         if (rule == RestitutionMixing::max) {
                           rule = RestitutionMixing::min;
                         } else if (rule == RestitutionMixing::min) {
                           rule = RestitutionMixing::max;
                         }
                       })};

const Catalog<Fault>::Entry friction_average{with_altered_scene(
    "friction-mixed-by-average", "mixes two frictions by their average, as the text of the article says",
    [](Scene& scene) { scene.mixing.friction = FrictionMixing::average; }, "the article, part 3: mixing rule")};

const Catalog<Fault>::Entry friction_pythagorean{with_altered_scene(
    "friction-mixed-otherwise",
    "swaps the mixing rules sqrt(a b) and sqrt(a^2 + b^2): the article prints one, its demo engine uses the other",
    [](Scene& scene) {
      scene.mixing.friction =
          scene.mixing.friction == FrictionMixing::geometric ? FrictionMixing::pythagorean : FrictionMixing::geometric;
    },
    "the article, part 3: mixing rule")};

const Catalog<Fault>::Entry layers{with_altered_scene(
    "layers-ignored", "every body collides with every other one",
    [](Scene& scene) { each_body(scene, [](Body& body) { body.layers = ~std::uint32_t{0}; }); },
    "the article, part 2: layers")};

const Catalog<Fault>::Entry layers_swapped{with_altered_scene(
    "layers-equal", "bodies collide only if their masks are equal, not if they share a bit",
    [](Scene& scene) {
      std::uint32_t next = 0;
      std::vector<std::pair<std::uint32_t, std::uint32_t>> bits;
      each_body(scene, [&](Body& body) {
        for (const auto& [mask, bit] : bits) {
          if (mask == body.layers) {
            body.layers = bit;
            return;
          }
        }
        bits.emplace_back(body.layers, std::uint32_t{1} << (next++ % 32));
        body.layers = bits.back().second;
      });
    },
    "the article, part 2: layers")};

const Catalog<Fault>::Entry static_for_dynamic{with_altered_scene(
    "friction-static-for-dynamic", "uses the static coefficient of friction for sliding too",
    [](Scene& scene) { each_surface(scene, [](Surface& of) { of.dynamic_friction = of.static_friction; }); },
    "the article, part 3: Coulomb's law")};

const Catalog<Fault>::Entry density{with_altered_scene("density-ignored", "every body has density 1", [](Scene& scene) {
  each_surface(scene, [](Surface& of) {
    if (of.density > 0) of.density = 1;
  });
})};

const Catalog<Fault>::Entry gravity_scale{with_altered_scene(
    "gravity-scale-ignored", "gravity is the same for all bodies",
    [](Scene& scene) { each_body(scene, [](Body& body) { body.gravity_scale = 1; }); }, "the article, part 2: bodies")};

const Catalog<Fault>::Entry damping{with_altered_scene("damping-ignored", "bodies are not damped", [](Scene& scene) {
  each_body(scene, [](Body& body) { body.linear_damping = body.angular_damping = 0; });
})};

const Catalog<Fault>::Entry fixed_rotation{
    with_altered_scene("fixed-rotation-ignored", "bodies with fixed rotation rotate",
                       [](Scene& scene) { each_body(scene, [](Body& body) { body.fixed_rotation = false; }); })};

const Catalog<Fault>::Entry kinematic{
    with_altered_scene("kinematic-stands", "kinematic bodies do not move", [](Scene& scene) {
      each_body(scene, [](Body& body) {
        if (body.type != BodyType::kinematic) return;
        body.velocity = {};
        body.angular_velocity = 0;
        body.path.reset();
      });
    })};

const Catalog<Fault>::Entry stiffness{with_altered_scene(
    "spring-1-percent", "springs are 1 % too stiff",
    [](Scene& scene) { each_force<Spring>(scene, [](Spring& spring) { spring.stiffness *= 1.01; }); })};

const Catalog<Fault>::Entry one_sided{with_altered_scene(
    "attraction-one-sided", "an attracting body is not attracted in return",
    [](Scene& scene) { each_force<Attraction>(scene, [](Attraction& pull) { pull.mutual = false; }); },
    "the article, part 2: forces")};

const Catalog<Fault>::Entry strength{with_altered_scene(
    "attraction-1-percent", "attraction is 1 % too strong",
    [](Scene& scene) { each_force<Attraction>(scene, [](Attraction& pull) { pull.strength *= 1.01; }); })};

const Catalog<Fault>::Entry constant{with_altered_scene(
    "force-lost", "a constant force is cleared before it acts",
    [](Scene& scene) {
      each_force<Constant>(scene, [](Constant& push) {
        push.force = {};
        push.torque = 0;
      });
    },
    "the article, part 2: forces")};

const Catalog<Fault>::Entry anchor{
    with_altered_scene("joint-anchor", "revolute joints are anchored 1 cm off", [](Scene& scene) {
      for (Joint& joint : scene.joints) {
        if (auto* pin = std::get_if<Revolute>(&joint)) {
          pin->anchor.x += 0.01;
        }
      }
    })};

const Catalog<Fault>::Entry joints_lost{
    with_altered_scene("joints-lost", "joints are ignored", [](Scene& scene) { scene.joints.clear(); })};

}  // namespace
}  // namespace plumb::scene_faults
