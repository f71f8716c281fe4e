#include "joints/anchors.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

class Weld : public JointModel {
 public:
  Weld(const WeldJoint& joint, const BodySet& bodies)
      : anchors_(joint.a, joint.b, joint.anchor, joint.anchor, bodies) {}

  void write(const JointPose& a, const JointPose& b, JointBlock& block) const override {
    const Reach reach(anchors_, a, b);
    block.equations = 3;
    reach.measure({1, 0}, block.equation[0]);
    reach.measure({0, 1}, block.equation[1]);
    measure_angle(anchors_, a, b, block.equation[2]);
  }

 private:
  Anchors anchors_;
};

}  // namespace

std::unique_ptr<const JointModel> model_of(const WeldJoint& joint, const BodySet& bodies) {
  return std::make_unique<Weld>(joint, bodies);
}

}  // namespace impulse::inline IMPULSE_PRECISION
