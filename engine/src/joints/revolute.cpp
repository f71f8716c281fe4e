#include "joints/anchors.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

class Revolute : public JointModel {
 public:
  Revolute(const RevoluteJoint& joint, const BodySet& bodies)
      : anchors_(joint.a, joint.b, joint.anchor, joint.anchor, bodies), limits_(joint.limits), motor_(joint.motor) {
    check(limits_, motor_);
  }

  void write(const JointPose& a, const JointPose& b, JointBlock& block) const override {
    const Reach reach(anchors_, a, b);
    block.equations = 2;
    reach.measure({1, 0}, block.equation[0]);
    reach.measure({0, 1}, block.equation[1]);
    JointRow angle;
    measure_angle(anchors_, a, b, angle);
    add_stops(angle, limits_, block);
    add_motor(angle, motor_, block);
  }

 private:
  Anchors anchors_;
  std::optional<Limits> limits_;
  std::optional<Motor> motor_;
};

}  // namespace

std::unique_ptr<const JointModel> model_of(const RevoluteJoint& joint, const BodySet& bodies) {
  return std::make_unique<Revolute>(joint, bodies);
}

}  // namespace impulse::inline IMPULSE_PRECISION
