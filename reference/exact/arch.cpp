#include "reference/exact/statics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "reference/exact/closed_form.h"
#include "reference/exact/recognise.h"
#include "scenarios/scene/mass.h"

namespace plumb {
namespace {

// A condition on the thrust through the first joint: k . (fx, fy, m) + c >= 0, with m about the origin.
struct Inequality {
  std::array<double, 3> k{};
  double c = 0;

  double at(const std::array<double, 3>& x) const { return k[0] * x[0] + k[1] * x[1] + k[2] * x[2] + c; }
};

Inequality multiplied(const Inequality& row, double by) {
  return {{by * row.k[0], by * row.k[1], by * row.k[2]}, by * row.c};
}

Inequality operator-(const Inequality& a, const Inequality& b) {
  return {{a.k[0] - b.k[0], a.k[1] - b.k[1], a.k[2] - b.k[2]}, a.c - b.c};
}

double determinant(const std::array<double, 3>& a, const std::array<double, 3>& b, const std::array<double, 3>& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// The point where three rows are zero (Cramer); returns false if the planes do not meet in a point.
bool meet(const Inequality& a, const Inequality& b, const Inequality& c, std::array<double, 3>& x) {
  const double whole = determinant(a.k, b.k, c.k);
  if (std::abs(whole) < 1e-12) return false;  // rows are of length 1
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<double, 3> of[] = {a.k, b.k, c.k};
    of[0][i] = -a.c;
    of[1][i] = -b.c;
    of[2][i] = -c.c;
    x[i] = determinant(of[0], of[1], of[2]) / whole;
  }
  return true;
}

// An intersection of half-spaces that contains no line is empty or has a corner: a point of three planes that satisfies
// every row.
bool feasible(const std::vector<Inequality>& rows) {
  constexpr double rounding = 1e-9;  // of numbers about 1
  std::array<double, 3> x{};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t l = 0; l < j; ++l) {
        if (!meet(rows[i], rows[j], rows[l], x)) continue;
        if (std::all_of(rows.begin(), rows.end(), [&](const Inequality& row) { return row.at(x) >= -rounding; }))
          return true;
      }
    }
  }
  return false;
}

}  // namespace

Arch::Arch(std::vector<BedJoint> joints, std::vector<Stone> stones, double friction)
    : joints_(std::move(joints)), stones_(std::move(stones)), friction_(friction) {}

// The thrust through joint k is that through the first joint plus the weights between them. For a joint p ... q with
// unit tangent t and normal n, N = F . n and the moment m about p, the thrust passes through p + e t with e N = +-m:
//   0 <= +-m <= |q - p| N   and   |F . t| <= mu N.
bool Arch::stands() const {
  double weight = 0;
  double size = 0;
  for (const Stone& stone : stones_) weight += length(stone.weight);
  for (const BedJoint& joint : joints_) size = std::max(size, length(joint.from - joints_.front().from));
  std::vector<Inequality> rows;
  const auto add = [&rows](const Inequality& row) {
    rows.push_back(multiplied(row, 1 / std::hypot(row.k[0], row.k[1], row.k[2])));
  };
  Vec force;          // sum of the weights so far, in units of the total weight
  double moment = 0;  // of those weights, about the start of the first joint
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const BedJoint& joint = joints_[i];
    const Vec p = (1 / size) * (joint.from - joints_.front().from);
    const double extent = length(joint.to - joint.from) / size;
    const Vec t = (1 / (extent * size)) * (joint.to - joint.from);
    const Vec n = joint.forward;
    const auto along = [&force](Vec d) { return Inequality{{d.x, d.y, 0}, dot(force, d)}; };
    const double side = cross(t, n);
    const Inequality about = multiplied(Inequality{{p.y, -p.x, 1}, moment - cross(p, force)}, side);  // m - p x F
    add(about);
    add(multiplied(along(n), extent) - about);
    add(multiplied(along(n), friction_) - along(t));
    add(multiplied(along(n), friction_) - along(-t));
    if (i == stones_.size()) break;
    const Vec pull = (1 / weight) * stones_[i].weight;
    force = force + pull;
    moment += cross((1 / size) * (stones_[i].center - joints_.front().from), pull);
  }
  return feasible(rows);
}

namespace {

struct StandingArch {
  std::vector<BodyState> start;
  void at(double, std::span<BodyState> out) const { write_states(start, out); }
};

std::vector<Vec> vertices_of(const Body& body) {
  std::vector<Vec> world;
  for (const Vec& vertex : only_shape<Polygon>(body)->vertices)
    world.push_back(body.position + rotated(vertex, body.angle));
  return world;
}

// The side that two stones, or a stone and the floor, have in common: the two vertices of the first stone for which
// `is_shared` holds. nullopt if there are not exactly two.
template <class Shared>
std::optional<BedJoint> side(const std::vector<Vec>& of, Vec towards, Shared is_shared) {
  std::vector<Vec> ends;
  std::copy_if(of.begin(), of.end(), std::back_inserter(ends), is_shared);
  if (ends.size() != 2) return std::nullopt;
  const Vec along = ends[1] - ends[0];
  const Vec normal = (1 / length(along)) * perpendicular(along);
  return BedJoint{ends[0], ends[1], dot(normal, towards - ends[0]) < 0 ? -normal : normal};
}

Recognised<StandingArch> recognise_arch(const Scene& scene) {
  if (const std::string reason = contact_refusal(scene); !reason.empty()) return reason;
  if (scene.bodies.size() < 2) return "handles only stones between abutments";
  const Body& ground = scene.bodies.front();
  const std::optional<Floor> floor = floor_of(ground, scene.gravity);
  if (!floor || std::isfinite(floor->to)) return "handles only abutments that are one half-space, the first body";
  const auto on_floor = [&](Vec point) {
    return std::abs(dot(point, floor->normal) - floor->offset) < geometry_tolerance;
  };
  std::vector<BedJoint> joints;
  std::vector<Arch::Stone> stones;
  double friction = 0;
  std::vector<Vec> before;
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    if (body.type != BodyType::dynamic || only_shape<Polygon>(body) == nullptr)
      return "handles only stones that are polygons";
    if (body.velocity != Vec{} || body.angular_velocity != 0) return "handles only bodies that start at rest";
    const Vec center = start_of(body).position;
    const std::vector<Vec> now = vertices_of(body);
    const auto shared = [&](Vec point) {
      return std::any_of(before.begin(), before.end(),
                         [&](Vec other) { return length(point - other) < geometry_tolerance; });
    };
    const std::optional<BedJoint> joint = i == 1 ? side(now, center, on_floor) : side(now, center, shared);
    if (!joint) return "handles only stones that share a side with the next one, in order";
    const double mu = mixed_coefficients(scene, ground, body).static_friction;
    if (i > 1 && mu != friction) return "supports only one coefficient of friction";
    friction = mu;
    joints.push_back(*joint);
    stones.push_back({center, mass_of(body).mass * gravity_of(scene, body)});
    before = now;
  }
  const auto last = side(before, before.front() - floor->normal, on_floor);
  if (!last || scene.bodies.size() < 3) return "handles only a chain of stones from floor to floor";
  joints.push_back({last->from, last->to, -floor->normal});
  if (!Arch(joints, stones, friction).stands())
    return "handles only arches that stand: no line of thrust stays within the joints";
  return StandingArch{start_of(scene)};
}

const Catalog<Engine>::Entry arch_entry{closed_form<StandingArch>(
    {.name = "arch",
     .about = "Stones of an arch at rest: some line of thrust stays within all joints",
     .source = "Heyman, The Stone Skeleton, Int. J. Solids Struct. 2 (1966); t/R >= 0.1075 for a semicircle: "
               "Milankovitch, Z. Math. Phys. 55 (1907)"},
    recognise_arch)};

}  // namespace
}  // namespace plumb
