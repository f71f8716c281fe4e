#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "reports/report.h"
#include "reports/timing/course.h"

namespace plumb {

/// The page with the data in place of its mark, or nothing and why.
std::optional<std::string> fill_page(std::string_view page, const nlohmann::ordered_json& data, std::string& why_not);

/// The same with a report's.
std::optional<std::string> fill_page(std::string_view page, const Report&, std::string& why_not);

/// What the charts are drawn from: per run the energy, momenta, distance from the closed form (from the case's first
/// engine where there is none) and deepest overlap over time, at no more than `most` moments, six digits each.
nlohmann::ordered_json series_of(std::span<const Course>, std::size_t most = 300);

}  // namespace plumb
