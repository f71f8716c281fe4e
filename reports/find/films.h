#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <vector>

#include "reports/find/complaint.h"
#include "reports/find/judge.h"
#include "reports/judge/contacts.h"
#include "reports/judge/relation.h"

namespace plumb {

/// The failing run of a finding, for readers.
struct FailingRun {
  std::vector<BodyPair> touching;  // up to where it fails; in order
  std::optional<Image> image;      // of the scene by the relation that it breaks
  /// For the page (see writers/replay.h): the run beside the closed form's or another engine's; of a broken relation
  /// the scene's run and the image's, whose times are the scene's.
  nlohmann::ordered_json films = nlohmann::ordered_json::array();
};

nlohmann::ordered_json as_json(const FailingRun&);
/// Throws nlohmann::json::exception or std::invalid_argument for what as_json does not write.
FailingRun failing_run_of(const nlohmann::ordered_json&);

/// Runs the scene again. `others` are engines to be seen beside this one, of which the first that runs the scene is.
FailingRun run_to_show(const Scene&, const Complaint&, const Suspect&, std::span<const Suspect> others);

}  // namespace plumb
