#include "joints/anchors.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

class Prismatic : public JointModel {
 public:
  Prismatic(const PrismaticJoint& joint, const BodySet& bodies)
      : anchors_(joint.a, joint.b, joint.anchor, joint.anchor, bodies),
        axis_(normalized(bodies.pose[joint.a.index].q.inverse() * joint.axis)),
        limits_(joint.limits),
        motor_(joint.motor) {
    check(limits_, motor_);
    if (!finite(joint.axis) || axis_ == Vec2{}) {
      throw std::invalid_argument("PrismaticJoint: axis must be finite and not zero");
    }
  }

  void write(const JointPose& a, const JointPose& b, JointBlock& block) const override {
    const Reach reach(anchors_, a, b);
    const Vec2 along = a.pose.q * axis_;
    block.equations = 2;
    reach.measure_in_a(perpendicular(along), block.equation[0]);
    measure_angle(anchors_, a, b, block.equation[1]);
    JointRow place;
    reach.measure_in_a(along, place);
    add_stops(place, limits_, block);
    add_motor(place, motor_, block);
  }

 private:
  Anchors anchors_;
  Vec2 axis_;  // frame of a
  std::optional<Limits> limits_;
  std::optional<Motor> motor_;
};

}  // namespace

std::unique_ptr<const JointModel> model_of(const PrismaticJoint& joint, const BodySet& bodies) {
  return std::make_unique<Prismatic>(joint, bodies);
}

}  // namespace impulse::inline IMPULSE_PRECISION
