#include "solver/touch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// rad; faces at a smaller angle lie on each other.
constexpr Real flush = Real{1} / 128;

constexpr Real infinity = std::numeric_limits<Real>::infinity();

/// m, by what the place of a point this far from its body's origin may be rounded, as found where the bodies are.
Real place_round_off(const Contact& contact, Real reach) {
  constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
  return 256 * epsilon * (reach + 1) + 4 * epsilon * (length(contact.found_a.p) + length(contact.found_b.p));
}

}  // namespace

Touch::Touch(const Contact& contact, const BodySet& bodies)
    : count_(contact.count), radius_a_(contact.radius_a), radius_b_(contact.radius_b) {
  const Faces faces = find_owner(contact, bodies);
  // From the frame of the contact's normal to that of ours.
  const Rotation to(dot(normal_, contact.normal), cross(normal_, contact.normal));
  for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
    const PointArms arms = arms_of(contact, i);
    arm_a_[i] = to * Vec2{arms.turn_a, -arms.cross_a};
    arm_b_[i] = to * Vec2{arms.turn_b, -arms.cross_b};
    apart_[i] = to * Vec2{radius_a_ + radius_b_ + contact.found_separation[i], 0};
    if (faces.flush && faces.ends[i].of_a != faces.ends[i].of_b) straighten(i, contact, faces);
  }
  trace(contact, bodies);
}

/// Of two faces that lie on each other, lets a point at a corner of one lie along the normal on the face of the other,
/// whichever of the two it was found by.
void Touch::straighten(std::size_t i, const Contact& contact, const Faces& faces) {
  const bool corner_of_a = faces.ends[i].of_a;
  const auto in_frame = [&](Vec2 v) { return Vec2{dot(normal_, v), dot(perpendicular(normal_), v)}; };
  const Vec2 facing = corner_of_a ? -faces.b.normal : faces.a.normal;
  const Vec2 between = contact.found_b.p - contact.found_a.p;
  const Vec2 on_a = corner_of_a ? faces.ends[i].corner : faces.a.from;
  const Vec2 on_b = between + (corner_of_a ? faces.b.from : faces.ends[i].corner);
  apart_[i] = {dot(facing, on_b - on_a) / dot(facing, normal_), 0};
  arm_a_[i] = corner_of_a ? in_frame(on_a) : in_frame(on_b) - apart_[i];
  arm_b_[i] = in_frame((corner_of_a ? on_a : on_b) - between);
  if (corner_of_a) arm_b_[i] += apart_[i];
}

/// The outline that a disc touches: both ways along a face, or the sides of a corner.
void Touch::trace(const Contact& contact, const BodySet& bodies) {
  const Shape& a = bodies.detail[contact.body_a].parts[contact.part_a].shape;
  const Shape& b = bodies.detail[contact.body_b].parts[contact.part_b].shape;
  outline_.is_of_a = b.type() == ShapeType::circle;
  if (outline_.is_of_a == (a.type() == ShapeType::circle)) return;
  const Shape& shape = outline_.is_of_a ? a : b;
  if (shape.type() == ShapeType::half_space) return;
  // Where ground goes on beyond a face, the search has left out what the face's plane stands for.
  if (contact.joins && normal_of_ != NormalOf::between) return;
  const Rotation q = outline_.is_of_a ? contact.found_a.q : contact.found_b.q;
  const Vec2 found = outline_.is_of_a ? arm_a_[0] : arm_b_[0];
  const auto in_frame = [&](Vec2 v) {
    const Vec2 world = q * v;
    return Vec2{dot(normal_, world), dot(perpendicular(normal_), world)};
  };
  const auto corner = [&](int i) { return in_frame(shape.vertex(i % shape.count())) - found; };
  const auto outward = [&](int i) { return in_frame(shape.normal(i)); };
  const auto rounding = [&](Vec2 to) { return place_round_off(contact, length(to) + length(found)); };
  const auto add = [&](std::size_t k, Vec2 end, Vec2 normal) {
    outline_.reaches[k] = length(end);
    outline_.along[k] = end / outline_.reaches[k];
    outline_.outward[k] = normal;
  };
  const int count = shape.count();
  for (int i = 0; i < count; ++i) {
    outline_.at_corner = length(corner(i)) <= rounding(corner(i));
    if (!outline_.at_corner) continue;
    const int before = i + count - 1;
    const bool either = count == 2;
    add(0, corner(i + 1), either ? Vec2{} : outward(i));
    add(1, corner(before), either ? Vec2{} : outward(before % count));
    return;
  }
  const Vec2 faces = outline_.is_of_a ? Vec2{1, 0} : Vec2{-1, 0};
  for (int i = 0; i < count; ++i) {
    const Vec2 from = corner(i);
    const Vec2 to = corner(i + 1);
    const bool between = dot(from, to) < 0 && std::abs(cross(from, to)) <= rounding(from) * length(to - from);
    if (!between || dot(outward(i), faces) <= 0) continue;
    add(0, to, outward(i));
    add(1, from, outward(i));
    return;
  }
}

Touch::Nearest Touch::nearest(const Displacement& a, const Displacement& b) const {
  const Displacement& turned = outline_.is_of_a ? a : b;
  const Real side = outline_.is_of_a ? Real{1} : Real{-1};
  const Vec2 centre = side * cores(0, a, b);
  Nearest best;
  Real least = std::numeric_limits<Real>::infinity();
  for (std::size_t k = 0; k < 2; ++k) {
    const Vec2 along = outline_.along[k] + turned.change(outline_.along[k]);
    const Real at = std::clamp(dot(centre, along), Real{0}, outline_.reaches[k]);
    const Vec2 apart = centre - at * along;
    const Real distance = length(apart);
    if (!(distance < least)) continue;
    least = distance;
    const bool beside = (at > 0 || !outline_.at_corner) && at < outline_.reaches[k];
    Vec2 normal = beside ? perpendicular(along) : normalized(apart);
    const Vec2 outward = outline_.outward[k] + turned.change(outline_.outward[k]);
    if (beside && dot(normal, outward == Vec2{} ? apart : outward) < 0) normal = -normal;
    best = {at * along, side * apart, side * normal, k, beside};
  }
  return best;
}

/// m, how far along a piece of the outline the disc's centre is.
Real Touch::reached(std::size_t piece, const Displacement& a, const Displacement& b) const {
  const Displacement& turned = outline_.is_of_a ? a : b;
  const Vec2 centre = outline_.is_of_a ? cores(0, a, b) : -cores(0, a, b);
  return dot(centre, outline_.along[piece] + turned.change(outline_.along[piece]));
}

Real Touch::until_corner(const Motion& from_a, const Motion& from_b, const Motion& to_a, const Motion& to_b) const {
  if (!outline_.known()) return 1;
  const std::array<Displacement, 2> a{since(found_a_, from_a), since(found_a_, to_a)};
  const std::array<Displacement, 2> b{since(found_b_, from_b), since(found_b_, to_b)};
  const Nearest from = nearest(a[0], b[0]);
  const Nearest to = nearest(a[1], b[1]);
  if (from.beside == to.beside && (from.piece == to.piece || !from.beside || !outline_.at_corner)) return 1;
  // The pieces of a corner begin where they meet; both of a face within it, and end at its corners.
  const std::size_t piece = from.beside == outline_.at_corner ? from.piece : to.piece;
  const Real first = reached(piece, a[0], b[0]);
  const Real last = reached(piece, a[1], b[1]);
  const Real end = (from.beside ? last : first) > 0 ? outline_.reaches[piece] : Real{0};
  return std::clamp((end - first) / (last - first), Real{0}, Real{1});
}

/// Which faces and corners make the contact, however its bodies are listed.
Touch::Faces Touch::find_owner(const Contact& contact, const BodySet& bodies) {
  const auto shape = [&](std::uint32_t body, std::uint16_t part) -> const Shape& {
    return bodies.detail[body].parts[part].shape;
  };
  normal_ = contact.normal;
  Faces faces{.a = face_towards(shape(contact.body_a, contact.part_a), contact.found_a.q, normal_),
              .b = face_towards(shape(contact.body_b, contact.part_b), contact.found_b.q, -normal_)};
  constexpr Real rounding = 64 * std::numeric_limits<Real>::epsilon();
  const bool is_of_a = faces.a.angle <= rounding;
  const bool is_of_b = faces.b.angle <= rounding;
  of_a_ = {Real{0.5}, Real{0.5}};
  if (!is_of_a && !is_of_b) return faces;
  const auto own = [this](NormalOf owner) {
    normal_of_ = owner;
    if (owner != NormalOf::both) of_a_[0] = of_a_[1] = owner == NormalOf::a ? Real{1} : Real{0};
  };
  own(is_of_a ? NormalOf::a : NormalOf::b);
  if (faces.a.angle > flush || faces.b.angle > flush) return faces;
  if (contact.joins) {  // the ground bears beyond the face's ends
    own(bodies.pushable(contact.body_a) ? NormalOf::b : NormalOf::a);
    normal_ = normal_of_ == NormalOf::a ? faces.a.normal : -faces.b.normal;
    return faces;
  }
  faces.flush = true;
  const Vec2 mean = normalized(faces.a.normal - faces.b.normal);
  bool corners_of_a = true;
  bool corners_of_b = true;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
    const End& end = faces.ends[i] = end_near(contact, i, faces, perpendicular(mean));
    corners_of_a = corners_of_a && end.of_a;
    corners_of_b = corners_of_b && end.of_b;
  }
  if (corners_of_b && !corners_of_a) {
    own(NormalOf::a);
    normal_ = faces.a.normal;
  } else if (corners_of_a && !corners_of_b) {
    own(NormalOf::b);
    normal_ = -faces.b.normal;
  } else {
    own(NormalOf::both);
    normal_ = mean;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
      const End& end = faces.ends[i];
      of_a_[i] = end.of_a == end.of_b ? Real{0.5} : end.of_b ? Real{1} : Real{0};
    }
  }
  return faces;
}

/// The face of a shape, rotated by q, that points most into a direction.
Touch::Face Touch::face_towards(const Shape& shape, Rotation q, Vec2 direction) {
  Face best;
  if (shape.type() == ShapeType::circle) return best;
  const int faces = shape.type() == ShapeType::half_space ? 1 : shape.count();
  for (int i = 0; i < faces; ++i) {
    const Vec2 normal = q * shape.normal(i);
    const Real off = std::abs(cross(normal, direction));
    if (!(dot(normal, direction) > 0 && off < best.angle)) continue;
    best = {.normal = normal, .angle = off, .ends = shape.type() != ShapeType::half_space};
    best.from = best.ends ? q * shape.vertex(i) : shape.offset() * normal;
    best.to = best.ends ? q * shape.vertex((i + 1) % shape.count()) : best.from;
  }
  return best;
}

Touch::Reach Touch::reach_of(const Face& face, Vec2 direction) {
  if (!face.ends) return {infinity, face.from};
  const Real from = dot(direction, face.from);
  const Real to = dot(direction, face.to);
  return from > to ? Reach{from, face.from} : Reach{to, face.to};
}

/// The end of the faces' overlap that is nearest to a point found.
Touch::End Touch::end_near(const Contact& contact, std::size_t i, const Faces& faces, Vec2 tangent) {
  const Vec2 between = contact.found_b.p - contact.found_a.p;
  End best;
  Real least = infinity;
  for (const Vec2 way : {tangent, -tangent}) {
    const Reach a = reach_of(faces.a, way);
    const Reach b = reach_of(faces.b, way);
    const Real to_b = b.most + dot(way, between);
    const Real off = std::abs(std::min(a.most, to_b) - dot(way, contact.points[i].arm_a));
    if (!(off < least)) continue;
    least = off;
    const Real rounding = place_round_off(contact, length(a.corner) + length(b.corner));
    best = {.of_a = a.most <= to_b + rounding,
            .of_b = to_b <= a.most + rounding,
            .corner = a.most < to_b ? a.corner : b.corner};
  }
  return best;
}

Touch::Touch(const Contact& contact, const BodySet& bodies, const Motion& a, const Motion& b) : Touch(contact, bodies) {
  found_a_ = back(a);
  found_b_ = back(b);
}

Touch::Touch(const Contact& contact, const BodySet& bodies, const Pose& start_a, const Pose& start_b)
    : Touch(contact, bodies) {
  found_a_ = between_poses(contact.found_a, start_a);
  found_b_ = between_poses(contact.found_b, start_b);
}

/// The inverse of a motion's rotation, and of its translation.
Touch::Displacement Touch::back(const Motion& found) { return {-found.d, -found.sine, found.drop}; }

Touch::Displacement Touch::between_poses(const Pose& then, const Pose& now) {
  if (then.q == now.q) return {now.p - then.p};
  const Rotation by = now.q * then.q.inverse();
  return {now.p - then.p, by.s, by.c - 1};
}

Touch::Displacement Touch::since(const Displacement& found, const Motion& now) {
  // cos - 1 of a sum of angles, without cancellation.
  return {found.d + now.d, now.sine * (1 + found.drop) + (1 + now.drop) * found.sine,
          now.drop + found.drop + now.drop * found.drop - now.sine * found.sine};
}

/// From the core of a to that of b, without their rounding radii.
Vec2 Touch::cores(std::size_t point, const Displacement& a, const Displacement& b) const {
  const Vec2 apart = b.d - a.d;
  const Vec2 moved{dot(normal_, apart), dot(perpendicular(normal_), apart)};
  return apart_[point] + moved + (b.change(arm_b_[point]) - a.change(arm_a_[point]));
}

/// The normal, in the frame of the one as found.
Vec2 Touch::direction(Vec2 cores, const Displacement& a, const Displacement& b) const {
  if (normal_of_ == NormalOf::a) return {1 + a.drop, a.sine};
  if (normal_of_ == NormalOf::b) return {1 + b.drop, b.sine};
  if (normal_of_ == NormalOf::both) return normalized(Vec2{2 + a.drop + b.drop, a.sine + b.sine});
  const bool round = radius_a_ + radius_b_ > 0 && apart_[0].x > 0;
  return round && cores != Vec2{} ? normalized(cores) : Vec2{1, 0};
}

TouchFrame Touch::at(const Motion& motion_a, const Motion& motion_b) const {
  const Displacement a = since(found_a_, motion_a);
  const Displacement b = since(found_b_, motion_b);
  TouchFrame frame;
  const Nearest of_disc = outline_.known() ? nearest(a, b) : Nearest{};
  const Vec2 n = outline_.known() ? of_disc.normal : direction(cores(0, a, b), a, b);
  const Vec2 t = perpendicular(n);
  frame.normal = n.x * normal_ + n.y * perpendicular(normal_);
  for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i) {
    const Vec2 apart = outline_.known() ? of_disc.apart : cores(i, a, b);
    Vec2 to_a = arm_a_[i] + a.change(arm_a_[i]);
    Vec2 to_b = arm_b_[i] + b.change(arm_b_[i]);
    (outline_.is_of_a ? to_a : to_b) += of_disc.foot;
    const Real along = dot(t, apart);
    to_a += of_a_[i] * along * t;
    to_b -= (1 - of_a_[i]) * along * t;
    PointArms& p = frame.points[i];
    p.separation = dot(n, apart) - (radius_a_ + radius_b_);
    p.turn_a = dot(n, to_a);
    p.turn_b = dot(n, to_b);
    p.cross_a = -dot(t, to_a);
    p.cross_b = -dot(t, to_b);
    p.dot_a = p.turn_a + radius_a_ + p.separation / 2;
    p.dot_b = p.turn_b - radius_b_ - p.separation / 2;
  }
  return frame;
}

Real Touch::gap(std::size_t point, const Motion& motion_a, const Motion& motion_b) const {
  const Displacement a = since(found_a_, motion_a);
  const Displacement b = since(found_b_, motion_b);
  if (outline_.known()) {
    const Nearest of_disc = nearest(a, b);
    return dot(of_disc.normal, of_disc.apart) - (radius_a_ + radius_b_);
  }
  return dot(direction(cores(0, a, b), a, b), cores(point, a, b)) - (radius_a_ + radius_b_);
}

Real Touch::moved(const Motion& motion_a, const Motion& motion_b, Real radius_a, Real radius_b) const {
  const Displacement a = since(found_a_, motion_a);
  const Displacement b = since(found_b_, motion_b);
  const auto turned = [](const Displacement& by) { return std::abs(by.sine) - by.drop; };
  return length(b.d - a.d) + turned(a) * radius_a + turned(b) * radius_b;
}

}  // namespace impulse::inline IMPULSE_PRECISION
