#include "scenarios/sag.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

#include "scenarios/scene/mass.h"

// At rest the weights F do no more work than the springs take up: A u = F, where a joint whose anchors are d apart
// pulls by w^2 K^-1 d. K is the inverse effective mass of both bodies at the anchor, J M^-1 J^T, by which a soft
// constraint is solved: an impulse p at the anchor changes the velocity there by K p. A weld is a hinge and an angular
// spring, solved one after the other, so K has no part that couples them. A is symmetric; where bodies can move without
// any spring, it is singular, but weights in equilibrium do no work there, which conjugate gradients need.
namespace plumb {
namespace {

struct SoftJoint {
  std::size_t a, b;
  Vec arm_a, arm_b;
  double xx = 0, xy = 0, yy = 0;  // N/m, of the anchors
  double turn = 0;                // N m/rad
};

using Displacements = std::vector<double>;  // for each body x, y and angle

double inner(const Displacements& a, const Displacements& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

class SoftJoints {
 public:
  SoftJoints(const Scene& scene, double frequency) {
    for (const Body& body : scene.bodies) masses_.push_back(mass_of(body));
    const double w = 2 * std::numbers::pi * frequency;
    for (const Joint& joint : scene.joints) {
      if (const auto* hinge = std::get_if<Revolute>(&joint)) {
        add(scene, hinge->a, hinge->b, hinge->anchor, w * w, false);
      } else if (const auto* weld = std::get_if<Weld>(&joint)) {
        add(scene, weld->a, weld->b, weld->anchor, w * w, true);
      } else {
        throw std::logic_error("sag_of knows hinges and welds only");
      }
    }
  }

  const Mass& mass(std::size_t body) const { return masses_[body]; }

  Displacements forces(const Displacements& u) const {
    Displacements sum(u.size());
    for (const SoftJoint& it : springs_) {
      const double* a = &u[3 * it.a];
      const double* b = &u[3 * it.b];
      const double x = b[0] - b[2] * it.arm_b.y - a[0] + a[2] * it.arm_a.y;
      const double y = b[1] + b[2] * it.arm_b.x - a[1] - a[2] * it.arm_a.x;
      const Vec force{it.xx * x + it.xy * y, it.xy * x + it.yy * y};
      const double torque = it.turn * (b[2] - a[2]);
      pull(sum, it.b, it.arm_b, force, torque);
      pull(sum, it.a, it.arm_a, {-force.x, -force.y}, -torque);
    }
    return sum;
  }

 private:
  void add(const Scene& scene, std::size_t a, std::size_t b, Vec anchor, double square, bool welded) {
    SoftJoint made{.a = a, .b = b, .arm_a = anchor - centre(scene, a), .arm_b = anchor - centre(scene, b)};
    double xx = 0;
    double xy = 0;
    double yy = 0;
    double turn = 0;
    for (const auto& [body, arm] : {std::pair{a, made.arm_a}, std::pair{b, made.arm_b}}) {
      const Mass& of = masses_[body];
      if (of.mass == 0) continue;
      xx += 1 / of.mass + arm.y * arm.y / of.inertia;
      xy -= arm.x * arm.y / of.inertia;
      yy += 1 / of.mass + arm.x * arm.x / of.inertia;
      turn += 1 / of.inertia;
    }
    const double determinant = xx * yy - xy * xy;
    made.xx = square * yy / determinant;
    made.xy = -square * xy / determinant;
    made.yy = square * xx / determinant;
    if (welded) made.turn = square / turn;
    springs_.push_back(made);
  }

  Vec centre(const Scene& scene, std::size_t body) const {
    const Body& of = scene.bodies[body];
    return of.position + rotated(masses_[body].center, of.angle);
  }

  void pull(Displacements& sum, std::size_t body, Vec arm, Vec force, double torque) const {
    if (masses_[body].mass == 0) return;
    sum[3 * body] += force.x;
    sum[3 * body + 1] += force.y;
    sum[3 * body + 2] += cross(arm, force) + torque;
  }

  std::vector<Mass> masses_;
  std::vector<SoftJoint> springs_;
};

}  // namespace

std::vector<Sag> sag_of(const Scene& scene, double frequency) {
  constexpr double enough = 1e-20;  // of the square of what is left
  const SoftJoints springs(scene, frequency);
  const std::size_t size = 3 * scene.bodies.size();
  Displacements left(size);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const double weight = springs.mass(i).mass * scene.bodies[i].gravity_scale;
    left[3 * i] = weight * scene.gravity.x;
    left[3 * i + 1] = weight * scene.gravity.y;
  }
  Displacements u(size);
  Displacements direction = left;
  double square = inner(left, left);
  const double at_first = square;
  for (std::size_t i = 0; i < 10 * size && square > enough * at_first; ++i) {
    const Displacements image = springs.forces(direction);
    const double step = square / inner(direction, image);
    for (std::size_t k = 0; k < size; ++k) {
      u[k] += step * direction[k];
      left[k] -= step * image[k];
    }
    const double next = inner(left, left);
    for (std::size_t k = 0; k < size; ++k) direction[k] = left[k] + next / square * direction[k];
    square = next;
  }
  std::vector<Sag> sags;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) sags.push_back({{u[3 * i], u[3 * i + 1]}, u[3 * i + 2]});
  return sags;
}

}  // namespace plumb
