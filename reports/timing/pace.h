#pragma once

#include <iosfwd>
#include <nlohmann/json.hpp>

/// A program that steps on request, so that two builds of Plumb can be timed side by side: one line of JSON in, one
/// out. It begins with {"pace": version, "facts": TimingFacts, "uncounted": why instructions are not counted, or ""}.
///
///   {"scene": text of a scene file, "engine": words of --engine, "dt": s}   -> {} once it can be stepped
///   {"runs": n, "steps": n, "chunk": n, "patience": s}                     -> {"cpu": [s], "wall": [s], "count": n}
///
/// A turn is `runs` runs from fresh starts, of as many steps each. What is told is of one run, by chunks of so many
/// steps: the median of each chunk's over all runs. The first run ends early, at a chunk's end, when its steps have
/// taken `patience`; the others are then as long. "count" is of instructions, null where they are not counted. What
/// cannot be done is answered by {"refused": why}.
namespace plumb {

constexpr int pace_version = 1;

/// Serves until there are no more requests.
void pace(std::istream&, std::ostream&);

}  // namespace plumb
