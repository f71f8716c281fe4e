#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/run/run.h"

namespace plumb {

/// The name of our engine as it is.
inline constexpr const char* ours = "impulse";

/// An engine that is searched for mistakes.
struct Suspect {
  std::string name;  // as it is given: "box2d", "impulse:solver=article", "fault:NAME", "closed-form:NAME"
  EngineConfig config;
  /// Set for a fault: what the right engine fails as well does not count.
  std::optional<EngineConfig> right = std::nullopt;
  /// Keep the engines of a fault, which no catalog holds.
  std::shared_ptr<const Engine> faulty = nullptr, sound = nullptr;
};

/// "NAME[:key=value,...]" is an engine, "fault:NAME" ours with a fault of `plumb prove`, "fault:all" with each of them
/// in turn, and "closed-form:NAME" or "closed-form:all" closed forms, in which any mistake is the judges'. Throws
/// std::invalid_argument, naming the nearest, for one that is not there.
std::vector<Suspect> parse_suspects(std::string_view word);

/// Whether it is a closed form, by its name: what it is found to break, judges mistake.
bool is_closed_form(std::string_view suspect);

/// Of several words; every engine as it is if there are none.
std::vector<Suspect> parse_suspects(const std::vector<std::string>& words);

}  // namespace plumb
