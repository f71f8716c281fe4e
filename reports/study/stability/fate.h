#pragma once

#include <span>
#include <string>

namespace plumb {

/// How a run ended that was watched for failing, from mild to wild.
enum class Fate {
  not_supported,
  holds,
  drifts,
  jitters,
  sinks,
  tunnels,
  topples,
  gains_energy,
  diverges,
  fails  // threw an error
};

/// How a fate is told, in words and as a letter of its own.
struct FateText {
  Fate fate;
  char letter;
  const char* name;
  const char* about;
};

/// All of them, in order.
std::span<const FateText> fates();

char letter_of(Fate);
const char* name_of(Fate);

/// Neither held nor left out.
bool is_failure(Fate);

/// How one run went: what went wrong first, when, and with whom.
struct Seen {
  Fate fate = Fate::holds;
  double time = 0;   // s, when it began; of what holds, the end
  std::string body;  // where it began; "" for the whole scene
  std::string why;   // of what is not supported or failed
};

}  // namespace plumb
