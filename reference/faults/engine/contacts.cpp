// Faults in the contacts that a solver is given.

#include <algorithm>
#include <atomic>

#include "reference/faults/engine/mutated_solver.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

const auto lost_point = mutated(
    {.name = "manifold-point-lost", .about = "the second point of every manifold is dropped", .mutates = "accurate"},
    [](MutatedStep& step) {
      for (Contact& contact : step.contacts) contact.count = std::min(contact.count, 1);
    });

bool is_disc(const BodySet& bodies, std::uint32_t body, std::uint16_t part) {
  return bodies.detail[body].parts[part].shape.type() == ShapeType::circle;
}

bool is_box(const BodySet& bodies, std::uint32_t body, std::uint16_t part) {
  return bodies.detail[body].parts[part].shape.count() == 4;
}

const auto flipped_normal =
    mutated({.name = "normal-flipped",
             .about = "the normal from b to a, for a box with a disc alone: one entry of the jump table not swapped",
             .source = "the article, part 3",
             .mutates = "accurate"},
            [](MutatedStep& step) {
              for (Contact& contact : step.contacts) {
                const bool pair = is_box(step.bodies, contact.body_a, contact.part_a) &&
                                  is_disc(step.bodies, contact.body_b, contact.part_b);
                if (pair) contact.normal = -contact.normal;
              }
            });

const auto frictionless_sticking = mutated({.name = "friction-dynamic-sticking",
                                            .about = "the dynamic coefficient while sticking",
                                            .source = "the article, part 3",
                                            .mutates = "accurate"},
                                           [](MutatedStep& step) {
                                             for (Contact& contact : step.contacts) {
                                               contact.static_friction = contact.dynamic_friction;
                                             }
                                           });

const auto bounce_short =
    mutated({.name = "restitution-2-percent", .about = "restitution 2 % too small", .mutates = "accurate"},
            [](MutatedStep& step) {
              for (Contact& contact : step.contacts) contact.restitution *= static_cast<Real>(0.98);
            });

const auto rough = mutated({.name = "friction-2-percent", .about = "friction 2 % too small", .mutates = "accurate"},
                           [](MutatedStep& step) {
                             for (Contact& contact : step.contacts) {
                               contact.static_friction *= static_cast<Real>(0.98);
                               contact.dynamic_friction *= static_cast<Real>(0.98);
                             }
                           });

// When two discs meet without bouncing, the second one is turned by 2 % less than friction's torque: what they turn
// about each other is lost.
const auto untwisted =
    mutated({.name = "disc-torque-2-percent",
             .about = "of two discs that meet without bouncing, one is turned 2 % too little: angular momentum is lost",
             .mutates = "accurate"},
            nullptr, [](MutatedStep& step) {
              for (const Contact& contact : step.contacts) {
                if (!contact.discs() || contact.restitution != 0) continue;
                const ContactPoint& at = contact.points[0];
                const Real torque = at.total_tangent_impulse * cross(at.arm_b, perpendicular(contact.normal));
                step.bodies.velocity[contact.body_b].w -=
                    static_cast<Real>(0.02) * step.bodies.inverse_mass[contact.body_b].i * torque;
              }
            });

constexpr Real skin = static_cast<Real>(0.01);  // m

const auto thick_skin = mutated({.name = "skin", .about = "shapes 1 cm thicker than they are", .mutates = "accurate"},
                                [](MutatedStep& step) {
                                  for (Contact& contact : step.contacts) {
                                    for (std::size_t p = 0; p < contact.points.size(); ++p) {
                                      contact.points[p].separation -= skin;
                                      contact.found_separation[p] -= skin;
                                    }
                                  }
                                });

const auto impulse_unscaled = mutated({.name = "impulse-not-scaled",
                                       .about = "warm starting with the impulse of a whole step in every sub-step",
                                       .mutates = "soft-step"},
                                      [](MutatedStep& step) {
                                        for (Contact& contact : step.contacts) {
                                          for (ContactPoint& point : contact.points) {
                                            point.normal_impulse *= static_cast<Real>(step.settings.substeps);
                                            point.tangent_impulse *= static_cast<Real>(step.settings.substeps);
                                          }
                                        }
                                      });

/// Addresses differ from run to run; a serial number of the world stands in for them.
class OrderByAddress : public MutatedSolver {
 public:
  OrderByAddress() : MutatedSolver("article"), address_(worlds++) {}

 private:
  void before(MutatedStep& step) override {
    if (step.contacts.empty()) return;
    const auto first = static_cast<std::ptrdiff_t>(address_ % step.contacts.size());
    std::rotate(step.contacts.begin(), step.contacts.begin() + first, step.contacts.end());
  }

  static inline std::atomic<std::size_t> worlds = 0;
  std::size_t address_;
};
const Faulty<Solver> order_by_address{
    {.name = "order-by-address",
     .about = "contacts solved in an order that depends on addresses: another one in every run",
     .mutates = "article"},
    [] { return std::make_unique<OrderByAddress>(); }};

/// A contact that has ended applies its last impulse once more.
class VanishedContacts : public MutatedSolver {
 public:
  VanishedContacts() : MutatedSolver("accurate") {}

 private:
  void before(MutatedStep& step) override {
    for (const Contact& old : last_) {
      const bool there = std::any_of(step.contacts.begin(), step.contacts.end(), [&](const Contact& one) {
        return one.body_a == old.body_a && one.body_b == old.body_b && one.part_a == old.part_a &&
               one.part_b == old.part_b;
      });
      if (!there) push(step.bodies, old);
    }
  }

  void after(MutatedStep& step) override { last_ = step.contacts; }

  static void push(BodySet& bodies, const Contact& contact) {
    for (std::size_t p = 0; p < static_cast<std::size_t>(contact.count); ++p) {
      const ContactPoint& at = contact.points[p];
      const Vec2 impulse =
          at.total_normal_impulse * contact.normal + at.total_tangent_impulse * perpendicular(contact.normal);
      const InverseMass a = bodies.inverse_mass[contact.body_a];
      const InverseMass b = bodies.inverse_mass[contact.body_b];
      bodies.velocity[contact.body_a].v -= a.m * impulse;
      bodies.velocity[contact.body_a].w -= a.i * cross(at.arm_a, impulse);
      bodies.velocity[contact.body_b].v += b.m * impulse;
      bodies.velocity[contact.body_b].w += b.i * cross(at.arm_b, impulse);
    }
  }

  std::vector<Contact> last_;
};
const Faulty<Solver> vanished_contacts{
    {.name = "warm-start-vanished", .about = "a contact that is gone pushes once more", .mutates = "accurate"},
    [] { return std::make_unique<VanishedContacts>(); }};

/// Has no speculative margin: a body may pass through anything thinner than its displacement in a step.
class Shortsighted : public MutatedSolver {
 public:
  Shortsighted() : MutatedSolver("accurate") {}
  Margin margin(const Settings&) const override { return {}; }
};
const Faulty<Solver> shortsighted{
    {.name = "margin-missing", .about = "no contact is looked for ahead of the step", .mutates = "accurate"},
    [] { return std::make_unique<Shortsighted>(); }};

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION
