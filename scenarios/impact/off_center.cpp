#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "scenarios/allowance.h"
#include "scenarios/parts.h"
#include "scenarios/scenario.h"
#include "scenarios/scene/mass.h"

// A body of several shapes, or a polygon, lands on one point that is not below its centre of mass. How it is written
// down, in which frame and wound which way, must make no difference.
namespace plumb::scenarios::off_center {
namespace {

constexpr double duration = 0.6;  // s, before the hammer's handle lands, too
constexpr double landing = 0.49;  // s, between two frames: at an impact no velocity is defined
enum class Form { quad, moved_quad, hammer };

Form form_of(const Parameters& p) { return static_cast<Form>(static_cast<int>(p.at("form"))); }

// Irregular, counter-clockwise, its lowest corner to the right of the centroid.
const std::vector<Vec> corners{{0.2, -0.6}, {0.9, 0.1}, {0.1, 0.7}, {-0.8, 0.2}};

// The same polygon in a frame of its own, `frame` turned by `angle` in that of `corners`, and the other way around.
constexpr Vec frame{1.5, -2};
constexpr double angle = 1.1;  // rad

std::vector<Vec> moved_corners() {
  std::vector<Vec> moved;
  for (const Vec& corner : corners) {
    const Vec from{corner.x - frame.x, corner.y - frame.y};
    moved.push_back(
        {std::cos(angle) * from.x + std::sin(angle) * from.y, std::cos(angle) * from.y - std::sin(angle) * from.x});
  }
  std::reverse(moved.begin(), moved.end());
  return moved;
}

Body body_of(Form form, double restitution) {
  const Surface of = surface(0, restitution);
  Body body{.name = "body"};
  switch (form) {
    case Form::quad:
      body.shapes = {{.geometry = Polygon{corners}, .surface = of}};
      break;
    case Form::moved_quad:
      body.position = frame;
      body.angle = angle;
      body.shapes = {{.geometry = Polygon{moved_corners()}, .surface = of}};
      break;
    case Form::hammer:  // a handle whose end is in the middle of a heavy, round head
      body.shapes = {{.geometry = Box{.size = {1.6, 0.2}, .center = {-0.8, 0}}, .surface = of},
                     {.geometry = Circle{.radius = 0.4, .center = {0, 0}}, .surface = surface(0, restitution, 3)}};
      break;
  }
  return body;
}

// Of the lowest point, in the world.
Vec lowest(const Body& body) {
  Vec low{0, 1e9};
  const auto add = [&](Vec local, double radius) {
    const double c = std::cos(body.angle);
    const double s = std::sin(body.angle);
    const Vec at{body.position.x + c * local.x - s * local.y, body.position.y + s * local.x + c * local.y - radius};
    if (at.y < low.y) low = at;
  };
  for (const Shape& shape : body.shapes) {
    if (const auto* polygon = std::get_if<Polygon>(&shape.geometry)) {
      for (const Vec& corner : polygon->vertices) add(corner, 0);
    } else if (const auto* circle = std::get_if<Circle>(&shape.geometry)) {
      add(circle->center, circle->radius);
    }
  }
  return low;
}

Body falling(const Parameters& p) {
  Body body = body_of(form_of(p), p.at("restitution"));
  body.position.y += p.at("speed") * landing - lowest(body).y;
  body.velocity = {0, -p.at("speed")};
  return body;
}

Scene scene(const Parameters& p) {
  Scene scene{.name = "off-center",
              .about = "A body lands on a point that is not below its centre of mass, without friction or gravity.",
              .gravity = {0, 0},
              .duration = duration};
  scene.bodies.push_back(level_ground(surface(0, p.at("restitution"))));
  scene.bodies.push_back(falling(p));
  return scene;
}

// With the arm c from the centre of mass to the lowest point and k^2 = I/m, J/m = (1+e) v/(1 + c^2/k^2). Nothing turns
// before, so neither v nor c depends on when the impact is detected. An engine may round corners by its skin and so be
// off by it in c: d(J/m)/dc is at most 0.65 (1+e) v/k, and d(c J/I)/dc at most (1+e) v/k^2. Positions are off by the
// velocity jump times the lag, and by the penetration that may be corrected, which turns the body by at most 1/(2 k)
// times it.
std::vector<Expectation> expectations(const Parameters& p) {
  const Body body = falling(p);
  const Mass mass = mass_of(body);
  const double v = p.at("speed");
  const double e = p.at("restitution");
  const Vec center{body.position.x + std::cos(body.angle) * mass.center.x - std::sin(body.angle) * mass.center.y,
                   body.position.y + std::sin(body.angle) * mass.center.x + std::cos(body.angle) * mass.center.y};
  const double c = lowest(body).x - center.x;
  const double k = std::sqrt(mass.inertia / mass.mass);
  const double jump = (1 + e) * v / (1 + c * c / (k * k));
  const double spin = c * jump / (k * k);
  const double after = duration - landing;
  const double y = center.y - v * duration + jump * after;
  const double reach = std::abs(center.x) + 4 + v + jump + std::abs(spin);
  const auto exact = [=](const Stepping& s) { return round_off(s, duration, reach); };
  const auto rise = [=](const Stepping& s) { return 0.65 * (1 + e) * v / k * s.skin + exact(s); };
  const auto about = [=](const Stepping& s) { return (1 + e) * v / (k * k) * s.skin + exact(s); };
  const auto depth = [=](const Stepping& s) { return v * lag(s) + s.contact_gap(); };
  const auto height = [=](const Stepping& s) { return jump * lag(s) + depth(s) + rise(s) * after + exact(s); };
  const auto turn = [=](const Stepping& s) {
    return std::abs(spin) * lag(s) + depth(s) / (2 * k) + about(s) * after + exact(s);
  };
  return {{.body = "body",
           .quantity = Quantity::vy,
           .expected = jump - v,
           .allowed = rise,
           .source = "J/m - v; arm within the skin"},
          {.body = "body", .quantity = Quantity::vx, .expected = 0, .allowed = exact, .source = "no friction"},
          {.body = "body",
           .quantity = Quantity::angular_velocity,
           .expected = spin,
           .allowed = about,
           .source = "c J/I; arm within the skin"},
          {.body = "body",
           .quantity = Quantity::x,
           .expected = center.x,
           .allowed = exact,
           .source = "no friction: the centre of mass stays above its place"},
          {.body = "body",
           .quantity = Quantity::y,
           .expected = y,
           .allowed = height,
           .source = "the velocity jump times the lag, and the penetration"},
          {.body = "body",
           .quantity = Quantity::angle,
           .expected = body.angle + spin * after,
           .allowed = turn,
           .source = "the velocity jump times the lag, and the penetration"}};
}

const Catalog<Scenario>::Entry entry{
    {.name = "off-center",
     .question = "Does a body get the right spin from an impact off its centre of mass, however its shape is written?",
     .parameters = {{.name = "form",
                     .value = 0,
                     .min = 0,
                     .max = 2,
                     .about =
                         "0: polygon, 1: the same in a frame far from it, clockwise, 2: hammer of a disc and a box",
                     .whole = true},
                    {.name = "speed", .value = 2, .min = 1.5, .max = 2.5, .unit = "m/s", .about = "of the approach"},
                    {.name = "restitution", .value = 0.7, .min = 0, .max = 1, .about = "of body and ground"}},
     .variants = {{"polygon", {}}, {"other frame", {{"form", 1}}}, {"hammer", {{"form", 2}}}},
     .closed_form = "first-impact",
     .scene = scene,
     .expectations = expectations,
     .phased = true}};

}  // namespace
}  // namespace plumb::scenarios::off_center
