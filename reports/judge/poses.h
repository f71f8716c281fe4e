#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reports/judge/relation.h"
#include "scenarios/images.h"

/// What relations share: comparing the poses of two runs that should be the same, and what round-off may change.
namespace plumb {

/// m, moment by moment: how far the poses of a run's dynamic bodies may be off by rounding alone, were differences not
/// to grow.
std::vector<double> pose_rounding(const RelationRun&);

/// The poses that a run should have, by moment and body.
using Poses = std::function<BodyState(std::size_t moment, std::size_t body)>;

/// A reason why poses may differ, and by how much: m, nullopt from where on it cannot be told.
struct Allowance {
  std::string reason;
  std::function<std::optional<double>(std::size_t moment, std::size_t body)> at;
};

/// Compares the poses of a run's dynamic bodies at its first `moments` moments with those that it should have, by the
/// first of the allowances that explains all differences, or else by the last.
RelationCheck compare_poses(const RelationRun&, std::size_t moments, const Poses&, std::span<const Allowance>);

/// Why two runs may differ that should be the same but for round-off; `rounding` is that of both together, by moment.
/// - Round-off, if nothing amplifies it.
/// - Round-off as the scene amplifies it; joints within the slop that the engine states, for it does not state where in
///   that they are; and where the images list things in another order, what a solver that iterates over them a stated
///   number of times leaves: `residue` is the stepping of a method with that error alone.
/// - From the moment on at which the engine decides by round-off in a tie, as its own runs from displaced starts show,
///   both are runs of the method: each is off by its own stated error, and no more.
/// The run must outlive them.
std::vector<Allowance> explained_by_rounding(const RelationRun&, std::vector<double> rounding,
                                             std::optional<Stepping> residue = std::nullopt);

/// The third of these: what is explained so far, and the method's own error, twice, from the moment on at which the
/// engine decides otherwise in runs from starts displaced by up to `size`, m.
Allowance decided_otherwise(const RelationRun&, const Allowance& explained, std::vector<double> rounding, double size);

/// Compares a run with that of a congruent image, in which the bodies follow `first` others. For `residue` see
/// explained_by_rounding.
RelationCheck compare_congruent(const RelationRun&, const RelationRun& image, const Congruence&, std::size_t first = 0,
                                std::optional<Stepping> residue = std::nullopt);

/// Why two runs may differ that are both off by a method's own error: round-off, or else that too. The run must outlive
/// them.
std::vector<Allowance> explained_by_method(const RelationRun&, std::vector<double> rounding, const Stepping& one,
                                           const Stepping& other);

/// A method whose only error is what its iterations over contacts and joints leave, and what those of their
/// positions leave of gaps. Nullopt if it has none.
std::optional<Stepping> residue_of(const Stepping&);

/// The check with the larger ratio; one that does not apply counts only if both do not.
RelationCheck worse(const RelationCheck&, const RelationCheck&);

/// Element by element, of lists of the same or different length.
std::vector<double> sum_of(const std::vector<double>&, const std::vector<double>&);

}  // namespace plumb
