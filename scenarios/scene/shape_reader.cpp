#include "scenarios/scene/shape_reader.h"

#include <cmath>
#include <vector>

#include "scenarios/scene/materials.h"
#include "scenarios/scene/scene_limits.h"

namespace plumb {
namespace {

constexpr double flat = 1e-9;  // rad, and a share of unit length: what ten written digits leave

void keys(const JsonReader& in, std::vector<const char*> required, std::vector<const char*> optional = {}) {
  required.push_back("type");
  for (const char* of_surface : {"material", "density", "friction", "restitution"}) optional.push_back(of_surface);
  in.object(required, optional);
}

Vec minus(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
double cross(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }
double length(Vec v) { return std::hypot(v.x, v.y); }

void must_part(const JsonReader& in, Vec from, Vec to) {
  if (length(minus(to, from)) < limits::size.least) in["to"].refuse("is where \"from\" is: the shape has no length");
}

Geometry circle(const JsonReader& in) {
  keys(in, {"radius"}, {"center"});
  return Circle{.radius = in["radius"].number(limits::size), .center = in.vector("center", {}, limits::coordinate)};
}

Geometry box(const JsonReader& in) {
  keys(in, {"size"}, {"center", "angle"});
  return Box{.size = in["size"].vector(limits::size),
             .center = in.vector("center", {}, limits::coordinate),
             .angle = in.number("angle", 0, limits::angle)};
}

// Convex: every corner turns the same way, and all of them together once round, for a pentagram turns the same way
// too. Going round once, the direction of travel changes between left and right twice.
void must_be_convex(const JsonReader& in, const std::vector<Vec>& v) {
  const std::size_t n = v.size();
  std::vector<Vec> edges;
  for (std::size_t i = 0; i < n; ++i) {
    edges.push_back(minus(v[(i + 1) % n], v[i]));
    if (length(edges[i]) < limits::size.least) in[(i + 1) % n].refuse("is where the vertex before it is");
  }
  const auto rightwards = [](Vec edge) { return edge.x > 0 || (edge.x == 0 && edge.y > 0); };
  int reversals = 0;
  double sense = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t corner = (i + 1) % n;
    const double turn = cross(edges[i], edges[corner]) / (length(edges[i]) * length(edges[corner]));
    if (std::abs(turn) < flat) in[corner].refuse("is on a line with its neighbours: leave it out");
    if (sense == 0) sense = turn;
    if (turn * sense < 0) in[corner].refuse("is where the polygon is not convex");
    if (rightwards(edges[i]) != rightwards(edges[corner])) ++reversals;
  }
  if (reversals != 2) in.refuse("expected a convex polygon, found one that winds round more than once");
}

Geometry polygon(const JsonReader& in) {
  keys(in, {"vertices"});
  const JsonReader list = in["vertices"];
  if (list.list() < 3) list.expected("three vertices or more");
  Polygon polygon;
  for (std::size_t i = 0; i < list.list(); ++i) polygon.vertices.push_back(list[i].vector(limits::coordinate));
  must_be_convex(list, polygon.vertices);
  return polygon;
}

Geometry capsule(const JsonReader& in) {
  keys(in, {"from", "to", "radius"});
  const Capsule capsule{.from = in["from"].vector(limits::coordinate),
                        .to = in["to"].vector(limits::coordinate),
                        .radius = in["radius"].number(limits::size)};
  must_part(in, capsule.from, capsule.to);
  return capsule;
}

Geometry segment(const JsonReader& in) {
  keys(in, {"from", "to"});
  const Segment segment{.from = in["from"].vector(limits::coordinate), .to = in["to"].vector(limits::coordinate)};
  must_part(in, segment.from, segment.to);
  return segment;
}

Geometry half_space(const JsonReader& in) {
  keys(in, {"normal", "offset"});
  const HalfSpace half_space{.normal = in["normal"].vector(limits::factor),
                             .offset = in["offset"].number(limits::coordinate)};
  if (std::abs(length(half_space.normal) - 1) > flat) in["normal"].refuse("expected a direction of length 1");
  return half_space;
}

constexpr Word<Geometry (*)(const JsonReader&)> kinds[] = {{"circle", circle},   {"box", box},
                                                           {"polygon", polygon}, {"capsule", capsule},
                                                           {"segment", segment}, {"halfspace", half_space}};

Surface named(const JsonReader& in) {
  std::vector<Word<Surface>> words;
  for (const Material& material : materials()) words.push_back({material.name.c_str(), material.surface});
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
  if (surface.dynamic_friction > surface.static_friction) in["dynamic"].expected("at most what \"static\" is");
}

// The material's, where one is named, with what is said beside it.
Surface read_surface(const JsonReader& in) {
  Surface surface = in.has("material") ? named(in["material"]) : Surface{};
  surface.density = in.number("density", surface.density, limits::density);
  surface.restitution = in.number("restitution", surface.restitution, limits::restitution);
  if (in.has("friction")) read_friction(in["friction"], surface);
  return surface;
}

}  // namespace

Shape read_shape(const JsonReader& in) {
  const auto read = in.kind<Geometry (*)(const JsonReader&)>(kinds);
  Shape shape{.geometry = read(in)};
  shape.surface = read_surface(in);
  return shape;
}

}  // namespace plumb
