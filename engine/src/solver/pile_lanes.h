#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "solver/colouring.h"
#include "solver/island.h"
#include "solver/lanes/kernels.h"
#include "solver/solver.h"

namespace impulse::inline IMPULSE_PRECISION {

/// The contacts of a pile in lanes, of as many as the kernels take at a time.
class PileLanes {
 public:
  static std::unique_ptr<PileLanes> make(const SolverKernels& kernels);
  PileLanes() = default;
  PileLanes(const PileLanes&) = delete;
  PileLanes& operator=(const PileLanes&) = delete;
  virtual ~PileLanes() = default;

  /// How many contacts: the colouring must have been made for that.
  virtual std::uint32_t at_a_time() const = 0;
  /// `row_of` has the row of each body of the world that has one; `no_row` is the first row of no body.
  virtual void lay_out(std::span<Contact> contacts, const BodySet& bodies, const Island& island,
                       const Colouring& colouring, const std::vector<std::uint32_t>& row_of, std::uint32_t no_row) = 0;
  // See ContactPasses.
  virtual void begin_late(const BodyRows& bodies) = 0;
  virtual void kick(const BodyRows& bodies) = 0;
  virtual void press(const BodyRows& bodies, Real h) = 0;
  virtual void relax(const BodyRows& bodies, bool again) = 0;
  virtual void settle(bool settling) = 0;
  /// Hands impulses and offsets back to the contacts that were laid out.
  virtual void store() = 0;
};

}  // namespace impulse::inline IMPULSE_PRECISION
