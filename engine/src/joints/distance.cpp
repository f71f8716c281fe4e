#include "joints/anchors.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

class RigidDistance : public JointModel {
 public:
  RigidDistance(const DistanceJoint& joint, const BodySet& bodies)
      : anchors_(joint.a, joint.b, joint.anchor_a, joint.anchor_b, bodies), length_(joint.length) {}

  void write(const JointPose& a, const JointPose& b, JointBlock& block) const override {
    const Reach reach(anchors_, a, b);
    const Real now = length(reach.apart);
    block.equations = 1;
    // Anchors in one place have no direction; any will push them apart.
    reach.measure(now > 0 ? reach.apart / now : Vec2{1, 0}, block.equation[0]);
    block.equation[0].error = now - length_;
  }

 private:
  Anchors anchors_;
  Real length_;
};

/// The spring itself is a force (World adds it); this only keeps the pair from colliding.
class SoftDistance : public JointModel {
 public:
  void write(const JointPose&, const JointPose&, JointBlock& block) const override { block.equations = 0; }
};

}  // namespace

std::unique_ptr<const JointModel> model_of(const DistanceJoint& joint, const BodySet& bodies) {
  if (!(finite(joint.length) && joint.length > 0)) {
    throw std::invalid_argument("DistanceJoint: length must be finite and above 0");
  }
  if (!(finite(joint.stiffness) && joint.stiffness >= 0 && finite(joint.damping) && joint.damping >= 0)) {
    throw std::invalid_argument("DistanceJoint: stiffness and damping must be finite and not negative");
  }
  if (joint.stiffness > 0) return std::make_unique<SoftDistance>();
  return std::make_unique<RigidDistance>(joint, bodies);
}

}  // namespace impulse::inline IMPULSE_PRECISION
