#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

/// The result of a stability study in one sentence, from its findings.
namespace plumb {

/// Adds to each map "best", the methods that are the best in it: those that agree with the law of physics where it has
/// the boundary, else those that hold the farthest. Methods that only one of several maps tries, as variants of others,
/// take no part.
void find_best(nlohmann::ordered_json& maps);

/// "impulse is the best or among the best in 8 of 10 maps, but in arch box2d holds farther. Of all methods' boundaries
/// with a theory, 60 of 80 agree with it." Takes the maps with their "best".
std::string sentence_of(const nlohmann::ordered_json& maps);

}  // namespace plumb
