#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "bodies/body_set.h"
#include "contacts/contact.h"
#include "contacts/contact_rows.h"
#include "solver/motion.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The normal and points of a contact at some poses of its bodies. Both arms of a point end in one place, midway in the
/// gap: an impulse that acts on two bodies in two places would change their angular momentum.
struct TouchFrame {
  Vec2 normal;  // unit, from a to b
  std::array<PointArms, 2> points;

  /// m/s, at which body b slides past a along the tangent at a point.
  Real sliding(std::size_t point, const Velocity& a, const Velocity& b) const {
    const PointArms& p = points[point];
    return dot(perpendicular(normal), b.v - a.v) + b.w * p.dot_b - a.w * p.dot_a;
  }
};

/// The geometry of a contact as its bodies move on from where it was found: normals and arms follow them exactly, as
/// long as the same features are nearest. A face's normal turns with its body, and the point on it follows the other
/// body's corner; the normal of rounded shapes points from core to core; two corners keep theirs. A disc touches what
/// is nearest of a face and its ends, or of a corner and the faces beside it.
class Touch {
 public:
  Touch() = default;
  /// The points of the contact, which were found when its bodies had moved by `a` and `b` since the start of the step.
  /// Without these, at the poses that the contact names.
  Touch(const Contact& contact, const BodySet& bodies, const Motion& a, const Motion& b);
  Touch(const Contact& contact, const BodySet& bodies, const Pose& start_a, const Pose& start_b);

  TouchFrame at(const Motion& a, const Motion& b) const;
  /// m, between the surfaces at a point: the separation of that frame.
  Real gap(std::size_t point, const Motion& a, const Motion& b) const;
  /// m, bound of the relative displacement of the surfaces since the points were found.
  Real moved(const Motion& a, const Motion& b, Real radius_a, Real radius_b) const;
  /// The share of a straight way from one pair of motions to another after which a disc passes the end of a face, so
  /// that its path no longer curves as it did; 1 if it does not.
  Real until_corner(const Motion& from_a, const Motion& from_b, const Motion& to_a, const Motion& to_b) const;

 private:
  /// A rigid motion, without the angle that it has turned by.
  struct Displacement {
    Vec2 d;  // m
    Real sine = 0;
    Real drop = 0;  // cosine - 1

    Vec2 change(Vec2 arm) const { return {drop * arm.x - sine * arm.y, sine * arm.x + drop * arm.y}; }
  };
  static Displacement since(const Displacement& found, const Motion& now);
  static Displacement back(const Motion& found);
  static Displacement between_poses(const Pose& then, const Pose& now);
  /// What the normal turns with.
  enum class NormalOf : std::uint8_t { between, a, b, both };

  /// The straight pieces of a core's outline that begin at the point found, in the frame of the normal.
  struct Outline {
    std::array<Vec2, 2> along;      // unit
    std::array<Real, 2> reaches{};  // m; 0 if there is no such piece
    std::array<Vec2, 2> outward;    // unit; 0 beside the end of a segment, which a disc may pass on either side
    bool is_of_a = false;
    bool at_corner = false;  // was it found
    bool known() const { return reaches[0] + reaches[1] > 0; }
  };
  struct Nearest {
    Vec2 foot;   // m, from the point found
    Vec2 apart;  // m, from the core of a to that of b
    Vec2 normal;
    std::size_t piece = 0;  // of the outline
    bool beside = false;    // it, and not at an end
  };

  /// A face of a core, in the world frame, from its body's origin.
  struct Face {
    Vec2 normal;
    Real angle = 2;     // sine of its angle with the direction sought
    Vec2 from, to;      // m
    bool ends = false;  // there, unlike a half-space
  };
  /// An end of the overlap of two faces: the corners that are there.
  struct End {
    bool of_a = false, of_b = false;
    Vec2 corner;  // m, of one of them, from its body's origin
  };
  struct Faces {
    Face a, b;
    bool flush = false;         // whether they lie on each other
    std::array<End, 2> ends{};  // then, at each point
  };
  static Face face_towards(const Shape& shape, Rotation q, Vec2 direction);
  /// How far a face reaches into a direction, and the corner there.
  struct Reach {
    Real most = 0;  // m, from the body's origin
    Vec2 corner;
  };
  static Reach reach_of(const Face& face, Vec2 direction);
  static End end_near(const Contact& contact, std::size_t point, const Faces& faces, Vec2 tangent);

  Touch(const Contact& contact, const BodySet& bodies);
  void straighten(std::size_t point, const Contact& contact, const Faces& faces);
  void trace(const Contact& contact, const BodySet& bodies);
  Nearest nearest(const Displacement& a, const Displacement& b) const;
  Real reached(std::size_t piece, const Displacement& a, const Displacement& b) const;
  Faces find_owner(const Contact& contact, const BodySet& bodies);
  Vec2 cores(std::size_t point, const Displacement& a, const Displacement& b) const;
  Vec2 direction(Vec2 cores, const Displacement& a, const Displacement& b) const;

  NormalOf normal_of_ = NormalOf::between;
  int count_ = 0;
  Vec2 normal_;
  Real radius_a_ = 0, radius_b_ = 0;  // m, by which the shapes are rounded
  // In the frame of the normal as found: arms of the cores' points.
  std::array<Vec2, 2> arm_a_, arm_b_;
  std::array<Vec2, 2> apart_;       // m, from the core of a to that of b
  std::array<Real, 2> of_a_{};      // share of each point's sliding by which it moves on a: all of it on a's face
  Outline outline_;                 // of what a disc touches
  Displacement found_a_, found_b_;  // from where the points were found to the start of the step
};

}  // namespace impulse::inline IMPULSE_PRECISION
