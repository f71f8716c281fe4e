// Faults of the question: our engine is given a scene that differs a little from the one that was asked.

#include <utility>

#include "reference/faults/fault.h"

namespace plumb {
namespace {

using Alter = void (*)(Scene&);

Fault asked_wrongly(std::string name, std::string about, Alter alter, std::string source = "") {
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
    asked_wrongly("restitution-min-for-max",
                  "the smaller of two restitutions where the larger is asked for, and the reverse", [](Scene& scene) {
                    RestitutionMixing& rule = scene.mixing.restitution;
                    if (rule == RestitutionMixing::max) {
                      rule = RestitutionMixing::min;
                    } else if (rule == RestitutionMixing::min) {
                      rule = RestitutionMixing::max;
                    }
                  })};

const Catalog<Fault>::Entry friction_average{asked_wrongly(
    "friction-mixed-by-average", "the mean of two frictions, as the article's prose has it",
    [](Scene& scene) { scene.mixing.friction = FrictionMixing::average; }, "row 20")};

const Catalog<Fault>::Entry friction_pythagorean{asked_wrongly(
    "friction-mixed-otherwise", "sqrt(a b) and sqrt(a^2 + b^2) taken for each other, as article and demo engine do",
    [](Scene& scene) {
      scene.mixing.friction =
          scene.mixing.friction == FrictionMixing::geometric ? FrictionMixing::pythagorean : FrictionMixing::geometric;
    },
    "row 20")};

const Catalog<Fault>::Entry layers{asked_wrongly(
    "layers-ignored", "every body collides with every other",
    [](Scene& scene) { each_body(scene, [](Body& body) { body.layers = ~std::uint32_t{0}; }); }, "row 15")};

const Catalog<Fault>::Entry layers_swapped{asked_wrongly(
    "layers-equal", "bodies collide if their masks are equal, not if they share a bit",
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
    "row 15")};

const Catalog<Fault>::Entry static_for_dynamic{asked_wrongly(
    "friction-static-for-dynamic", "one coefficient of friction, the static one",
    [](Scene& scene) { each_surface(scene, [](Surface& of) { of.dynamic_friction = of.static_friction; }); },
    "row 19")};

const Catalog<Fault>::Entry density{asked_wrongly("density-ignored", "every body of the density 1", [](Scene& scene) {
  each_surface(scene, [](Surface& of) {
    if (of.density > 0) of.density = 1;
  });
})};

const Catalog<Fault>::Entry gravity_scale{asked_wrongly(
    "gravity-scale-ignored", "gravity the same for all",
    [](Scene& scene) { each_body(scene, [](Body& body) { body.gravity_scale = 1; }); }, "row 7")};

const Catalog<Fault>::Entry damping{asked_wrongly("damping-ignored", "no damping", [](Scene& scene) {
  each_body(scene, [](Body& body) { body.linear_damping = body.angular_damping = 0; });
})};

const Catalog<Fault>::Entry fixed_rotation{
    asked_wrongly("fixed-rotation-ignored", "bodies turn that must not",
                  [](Scene& scene) { each_body(scene, [](Body& body) { body.fixed_rotation = false; }); })};

const Catalog<Fault>::Entry kinematic{
    asked_wrongly("kinematic-stands", "kinematic bodies stand still", [](Scene& scene) {
      each_body(scene, [](Body& body) {
        if (body.type != BodyType::kinematic) return;
        body.velocity = {};
        body.angular_velocity = 0;
      });
    })};

const Catalog<Fault>::Entry stiffness{asked_wrongly("spring-1-percent", "springs 1 % too stiff", [](Scene& scene) {
  each_force<Spring>(scene, [](Spring& spring) { spring.stiffness *= 1.01; });
})};

const Catalog<Fault>::Entry one_sided{asked_wrongly(
    "attraction-one-sided", "what attracts is not attracted in turn",
    [](Scene& scene) { each_force<Attraction>(scene, [](Attraction& pull) { pull.mutual = false; }); }, "row 12")};

const Catalog<Fault>::Entry strength{asked_wrongly(
    "attraction-1-percent", "attraction 1 % too strong",
    [](Scene& scene) { each_force<Attraction>(scene, [](Attraction& pull) { pull.strength *= 1.01; }); })};

const Catalog<Fault>::Entry constant{asked_wrongly(
    "force-lost", "a constant force is cleared before it acts",
    [](Scene& scene) {
      each_force<Constant>(scene, [](Constant& push) {
        push.force = {};
        push.torque = 0;
      });
    },
    "row 12")};

const Catalog<Fault>::Entry anchor{
    asked_wrongly("joint-anchor", "joints anchored 1 cm beside their places", [](Scene& scene) {
      for (Joint& joint : scene.joints) {
        if (auto* pin = std::get_if<Revolute>(&joint)) {
          pin->anchor.x += 0.01;
        }
      }
    })};

const Catalog<Fault>::Entry joints_lost{
    asked_wrongly("joints-lost", "no joint holds", [](Scene& scene) { scene.joints.clear(); })};

}  // namespace
}  // namespace plumb
