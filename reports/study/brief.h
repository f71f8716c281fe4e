#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "reports/study/study.h"

namespace plumb {

/// The command line of a study's short form, "plumb study NAME ...". The study must have one.
std::string brief_command(const Study&);

/// Its document, as `plumb study` writes it. Nothing is kept on the way. `tell` is called with each point that is
/// known, how many are and how many there will be. Throws std::logic_error if its options are not the study's own.
nlohmann::ordered_json brief_document(
    const Study&, int jobs, const std::function<void(const std::string& key, std::size_t done, std::size_t of)>& tell);

}  // namespace plumb
