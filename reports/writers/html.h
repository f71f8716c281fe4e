#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "reports/report.h"

/// The page: one HTML file that holds its data.
namespace plumb {

/// The page without data. Its one `<!--plumb-data-->` is where
/// `<script type="application/json" id="plumb-data">{"report": packed, "curves": ..., "replays": ..., "studies": [...]}
/// </script>` goes. `curves` are those of run_curves.h, `replays` those of replay.h. What is packed (packed.h) is the
/// text of a JSON value: browsers take ten times as long to read it from a file as to unpack it. Empty if Node.js 18 or
/// the page's npm packages were missing when Plumb was built.
std::string_view page_template();

/// A program for Node.js 18 or newer: `node FILE.cjs PAGE.html FOLDER` writes each chart of a page as an SVG. Empty
/// if page_template() is.
std::string_view picture_program();

/// The page with the data in place of its mark, or nullopt and the reason in `why_not`.
std::optional<std::string> fill_page(std::string_view page, const nlohmann::ordered_json& data, std::string& why_not);

/// The same with the data of a report.
std::optional<std::string> fill_page(std::string_view page, const Report&, std::string& why_not);

}  // namespace plumb
