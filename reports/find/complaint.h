#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

/// What judges say of one engine in one scene.
namespace plumb {

/// Something that a run got wrong.
struct Complaint {
  std::string judge;  // "run", "invariant", "closed form", "converged", "relation"
  std::string what;   // "diverged", "energy", "x", "mirror"
  int sign = 0;       // of the error, where it has one: below or above the truth
  std::string where;  // body, or "a - b"; "" for the whole scene
  std::string unit;
  double value = 0, tolerance = 0;  // of an error, in the unit
  double ratio = 0;                 // error_ratio(value, tolerance)
  double time = 0;                  // s

  /// The reason for which a scene fails: "invariant energy", "converged x +". Two complaints with the same reason count
  /// as the same fault.
  std::string reason() const;
  /// With numbers: "breaks energy by 2.4 J (allowed .01 J) at .5 s: box 1".
  std::string words() const;
};

/// How one engine did in one scene.
struct Opinion {
  std::string status;                 // "ok", "failed", "not supported"
  std::string note;                   // why it is not ok
  bool by_laws_alone = false;         // as judging it by more took too long, or crashed
  std::vector<Complaint> complaints;  // at most one of a reason, in the order of judges
  std::optional<double> energy_rise;  // relative to the scene's energy range; nullopt if energy comes from outside
  std::optional<double> overlap;      // m, the deepest

  const Complaint* of(const std::string& reason) const;
};

nlohmann::ordered_json as_json(const Complaint&);
nlohmann::ordered_json as_json(const Opinion&);
/// Throw nlohmann::json::exception for what as_json does not write.
Complaint complaint_of(const nlohmann::ordered_json&);
Opinion opinion_of(const nlohmann::ordered_json&);

}  // namespace plumb
