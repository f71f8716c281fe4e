#include "scenarios/scene/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "scenarios/scene/scene_fields.h"

namespace plumb {
namespace {

constexpr double flat = 1e-9;  // rad, and relative to unit length: the precision of ten written digits

void check_keys(const JsonReader& in, std::vector<const char*> required, std::vector<const char*> optional = {}) {
  required.push_back("type");
  for (const char* of_surface : {"material", "density", "friction", "restitution"}) optional.push_back(of_surface);
  in.object(required, optional);
}

void check_length(const JsonReader& in, Vec from, Vec to) {
  if (length(to - from) < limits::size.least) in["to"].refuse("equals \"from\": the shape has no length");
}

// Circle

Area area_of_kind(const Circle& circle) {
  const double area = std::numbers::pi * circle.radius * circle.radius;
  return {area, circle.center, area * circle.radius * circle.radius / 2};
}

Outline outline_of_kind(const Circle& circle) { return {.points = {circle.center}, .radius = circle.radius}; }

Geometry mapped_kind(const Circle& circle, const FrameMap& map) {
  return Circle{map.factor * circle.radius, map.of_point(circle.center)};
}

Geometry read_circle(const JsonReader& in) {
  check_keys(in, {"radius"}, {"center"});
  return Circle{.radius = in["radius"].number(limits::size), .center = in.vector("center", {}, limits::coordinate)};
}

OrderedJson kind_as_json(const Circle& circle) {
  OrderedJson json{{"radius", circle.radius}};
  write_unless(json, "center", circle.center, {});
  return json;
}

// Box

Area area_of_kind(const Box& box) {
  const double area = box.size.x * box.size.y;
  return {area, box.center, area * (box.size.x * box.size.x + box.size.y * box.size.y) / 12};
}

Outline outline_of_kind(const Box& box) {
  Outline outline;
  for (const Vec corner : {Vec{-1, -1}, Vec{1, -1}, Vec{1, 1}, Vec{-1, 1}}) {
    const Vec half{corner.x * box.size.x / 2, corner.y * box.size.y / 2};
    outline.points.push_back(box.center + rotated(half, box.angle));
  }
  return outline;
}

Geometry mapped_kind(const Box& box, const FrameMap& map) {
  return Box{map.factor * box.size, map.of_point(box.center), map.of_angle(box.angle)};
}

Geometry read_box(const JsonReader& in) {
  check_keys(in, {"size"}, {"center", "angle"});
  return Box{.size = in["size"].vector(limits::size),
             .center = in.vector("center", {}, limits::coordinate),
             .angle = in.number("angle", 0, limits::angle)};
}

OrderedJson kind_as_json(const Box& box) {
  OrderedJson json{{"size", as_json(box.size)}};
  write_unless(json, "center", box.center, {});
  write_unless(json, "angle", box.angle, 0.0);
  return json;
}

// Polygon

// Green's theorem turns the integrals over the area into sums over edges p -> q, with c = p x q:
//   A = sum c / 2,   S = sum c (p + q) / 6,   J = sum c (p.p + p.q + q.q) / 12   (J about the origin).
// The first vertex is the origin, so that a polygon far from the origin of its body frame loses no digits.
Area area_of_kind(const Polygon& polygon) {
  const std::vector<Vec>& v = polygon.vertices;
  if (v.size() < 3) return {};
  double area = 0;
  double moment = 0;
  Vec first;
  for (std::size_t i = 1; i + 1 < v.size(); ++i) {
    const Vec p = v[i] - v[0];
    const Vec q = v[i + 1] - v[0];
    const double c = cross(p, q);
    area += c / 2;
    first.x += c * (p.x + q.x) / 6;
    first.y += c * (p.y + q.y) / 6;
    moment += c * (p.x * p.x + p.y * p.y + p.x * q.x + p.y * q.y + q.x * q.x + q.y * q.y) / 12;
  }
  if (area == 0) return {};
  const Vec center{first.x / area, first.y / area};
  // Clockwise vertices flip every sign; the ratio above is the same for both windings.
  moment = std::abs(moment) - std::abs(area) * (center.x * center.x + center.y * center.y);
  return {std::abs(area), {v[0].x + center.x, v[0].y + center.y}, moment};
}

Outline outline_of_kind(const Polygon& polygon) { return {.points = polygon.vertices}; }

Geometry mapped_kind(Polygon polygon, const FrameMap& map) {
  for (Vec& vertex : polygon.vertices) vertex = map.of_point(vertex);
  if (map.mirrored) std::reverse(polygon.vertices.begin(), polygon.vertices.end());  // keeps the winding
  return polygon;
}

// In a convex polygon all corners turn in the same sense and the edges make one full turn in total (a pentagram's
// corners turn in one sense too, but make two). In one full turn the edges reverse between leftwards and rightwards
// twice.
void check_convex(const JsonReader& in, const std::vector<Vec>& v) {
  const std::size_t n = v.size();
  std::vector<Vec> edges;
  for (std::size_t i = 0; i < n; ++i) {
    edges.push_back(v[(i + 1) % n] - v[i]);
    if (length(edges[i]) < limits::size.least) in[(i + 1) % n].refuse("equals the vertex before it");
  }
  const auto rightwards = [](Vec edge) { return edge.x > 0 || (edge.x == 0 && edge.y > 0); };
  int reversals = 0;
  double sense = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t corner = (i + 1) % n;
    const double turn = cross(edges[i], edges[corner]) / (length(edges[i]) * length(edges[corner]));
    if (std::abs(turn) < flat) in[corner].refuse("lies on the line through its neighbours: leave it out");
    if (sense == 0) sense = turn;
    if (turn * sense < 0) in[corner].refuse("the polygon is not convex at this vertex");
    if (rightwards(edges[i]) != rightwards(edges[corner])) ++reversals;
  }
  if (reversals != 2) in.refuse("expected a convex polygon, found one that winds around more than once");
}

Geometry read_polygon(const JsonReader& in) {
  check_keys(in, {"vertices"});
  const JsonReader list = in["vertices"];
  if (list.list() < 3) list.expected("at least three vertices");
  Polygon polygon;
  for (std::size_t i = 0; i < list.list(); ++i) polygon.vertices.push_back(list[i].vector(limits::coordinate));
  check_convex(list, polygon.vertices);
  return polygon;
}

OrderedJson kind_as_json(const Polygon& polygon) {
  OrderedJson vertices = OrderedJson::array();
  for (const Vec& vertex : polygon.vertices) vertices.push_back(as_json(vertex));
  return {{"vertices", std::move(vertices)}};
}

// Capsule

// A rectangle L x 2r and two half discs. The centroid of a half disc is c = 4 r/(3 pi) from its flat side. By the
// parallel-axis theorem the two half discs, L/2 + c from the middle of the capsule, together have
// A_d (r^2/2 + L^2/4 + L c), where A_d is the area of the whole disc.
Area area_of_kind(const Capsule& capsule) {
  const double l = length(capsule.to - capsule.from);
  const double r = capsule.radius;
  const double rectangle = l * 2 * r;
  const double disc = std::numbers::pi * r * r;
  const double c = 4 * r / (3 * std::numbers::pi);
  return {rectangle + disc,
          {(capsule.from.x + capsule.to.x) / 2, (capsule.from.y + capsule.to.y) / 2},
          rectangle * (l * l + 4 * r * r) / 12 + disc * (r * r / 2 + l * l / 4 + l * c)};
}

Outline outline_of_kind(const Capsule& capsule) {
  return {.points = {capsule.from, capsule.to}, .radius = capsule.radius};
}

Geometry mapped_kind(const Capsule& capsule, const FrameMap& map) {
  return Capsule{map.of_point(capsule.from), map.of_point(capsule.to), map.factor * capsule.radius};
}

Geometry read_capsule(const JsonReader& in) {
  check_keys(in, {"from", "to", "radius"});
  const Capsule capsule{.from = in["from"].vector(limits::coordinate),
                        .to = in["to"].vector(limits::coordinate),
                        .radius = in["radius"].number(limits::size)};
  check_length(in, capsule.from, capsule.to);
  return capsule;
}

OrderedJson kind_as_json(const Capsule& capsule) {
  return {{"from", as_json(capsule.from)}, {"to", as_json(capsule.to)}, {"radius", capsule.radius}};
}

// Segment

Area area_of_kind(const Segment&) { return {}; }

Outline outline_of_kind(const Segment& segment) { return {.points = {segment.from, segment.to}}; }

Geometry mapped_kind(const Segment& segment, const FrameMap& map) {
  return Segment{map.of_point(segment.from), map.of_point(segment.to)};
}

Geometry read_segment(const JsonReader& in) {
  check_keys(in, {"from", "to"});
  const Segment segment{.from = in["from"].vector(limits::coordinate), .to = in["to"].vector(limits::coordinate)};
  check_length(in, segment.from, segment.to);
  return segment;
}

OrderedJson kind_as_json(const Segment& segment) {
  return {{"from", as_json(segment.from)}, {"to", as_json(segment.to)}};
}

// Half-space

Area area_of_kind(const HalfSpace&) { return {}; }

Outline outline_of_kind(const HalfSpace& half_space) { return {.halfspace = half_space}; }

Geometry mapped_kind(const HalfSpace& half_space, const FrameMap& map) {
  const Vec normal = map.of_direction(half_space.normal);
  return HalfSpace{normal, map.factor * half_space.offset - dot(normal, map.origin)};
}

Geometry read_half_space(const JsonReader& in) {
  check_keys(in, {}, {"normal", "offset"});
  const HalfSpace level;
  const HalfSpace half_space{.normal = in.vector("normal", level.normal, limits::factor),
                             .offset = in.number("offset", level.offset, limits::coordinate)};
  if (std::abs(length(half_space.normal) - 1) > flat) in["normal"].refuse("expected a direction of length 1");
  return half_space;
}

OrderedJson kind_as_json(const HalfSpace& half_space) {
  return {{"normal", as_json(half_space.normal)}, {"offset", half_space.offset}};
}

// In the order of Geometry.
using ReadGeometry = Geometry (*)(const JsonReader&);
constexpr Word<ReadGeometry> shape_kinds[] = {{"circle", read_circle},   {"box", read_box},
                                              {"polygon", read_polygon}, {"capsule", read_capsule},
                                              {"segment", read_segment}, {"halfspace", read_half_space}};
static_assert(std::size(shape_kinds) == std::variant_size_v<Geometry>);

// Surfaces

Surface read_material(const JsonReader& in) {
  std::vector<Word<Surface>> words;
  for (const NamedSurface& material : materials()) words.push_back({material.name.c_str(), material.surface});
  return in.one_of<Surface>(words);
}

void read_friction(const JsonReader& in, Surface& surface) {
  if (in.value().is_number()) {
    surface.static_friction = surface.dynamic_friction = in.number(limits::friction);
    return;
  }
  if (!in.value().is_object()) in.expected("a number, or an object with \"static\" and \"dynamic\"");
  in.object({"static", "dynamic"}, {});
  surface.static_friction = in["static"].number(limits::friction);
  surface.dynamic_friction = in["dynamic"].number(limits::friction);
  if (surface.dynamic_friction > surface.static_friction) in["dynamic"].expected("at most the value of \"static\"");
}

// The named material's surface if there is one; values given beside it take precedence.
Surface read_surface(const JsonReader& in) {
  Surface surface = in.has("material") ? read_material(in["material"]) : Surface{};
  surface.density = in.number("density", surface.density, limits::density);
  surface.restitution = in.number("restitution", surface.restitution, limits::restitution);
  if (in.has("friction")) read_friction(in["friction"], surface);
  return surface;
}

void write_surface(OrderedJson& json, const Surface& surface) {
  json["density"] = surface.density;
  if (same_bits(surface.static_friction, surface.dynamic_friction)) {
    json["friction"] = surface.static_friction;
  } else {
    json["friction"] = {{"static", surface.static_friction}, {"dynamic", surface.dynamic_friction}};
  }
  json["restitution"] = surface.restitution;
}

}  // namespace

const char* kind_name(const Geometry& geometry) { return shape_kinds[geometry.index()].word; }

Area area_of(const Geometry& geometry) {
  return std::visit([](const auto& kind) { return area_of_kind(kind); }, geometry);
}

Outline outline_of(const Geometry& geometry, Vec origin) {
  const Outline outline = std::visit([](const auto& kind) { return outline_of_kind(kind); }, geometry);
  return placed(outline, -origin, 0);
}

Outline placed(const Outline& outline, Vec position, double angle) {
  Outline there = outline;
  const Vec facing{std::cos(angle), std::sin(angle)};
  for (Vec& point : there.points) point = position + rotated(point, facing);
  if (there.halfspace) {
    there.halfspace->normal = rotated(outline.halfspace->normal, facing);
    there.halfspace->offset += dot(there.halfspace->normal, position);
  }
  return there;
}

Geometry mapped(const Geometry& geometry, const FrameMap& map) {
  return std::visit([&map](const auto& kind) { return mapped_kind(kind, map); }, geometry);
}

Shape read_shape(const JsonReader& in) {
  const auto read = in.kind<ReadGeometry>(shape_kinds);
  Shape shape{.geometry = read(in)};
  shape.surface = read_surface(in);
  return shape;
}

nlohmann::ordered_json as_json(const Shape& shape) {
  OrderedJson json{{"type", kind_name(shape.geometry)}};
  json.update(std::visit([](const auto& kind) { return kind_as_json(kind); }, shape.geometry));
  write_surface(json, shape.surface);
  return json;
}

}  // namespace plumb
