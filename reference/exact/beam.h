#pragma once

namespace plumb {

/// A beam that lies on two supports without moving: the reactions are the lever's (Archimedes). Holds for ever.
class Beam {
 public:
  /// weight N; left and right m from its centre to the supports, both positive.
  Beam(double weight, double left, double right);

  double left() const { return left_; }    // N
  double right() const { return right_; }  // N

 private:
  double left_, right_;
};

}  // namespace plumb
