#pragma once

#include <string_view>

namespace plumb {

/// The page, ready but for its data: the one `<!--plumb-data-->` in it is where
/// `<script type="application/json" id="plumb-data">{"report": ..., "series": ..., "studies": [...]}</script>` goes.
/// Empty in a build that had no Node.js 18 or could not get the page's npm packages.
std::string_view page_template();

/// A program for Node.js 18 or newer: `node FILE.cjs PAGE.html FOLDER` writes each chart of a page as an SVG. Empty
/// where the page is.
std::string_view picture_program();

}  // namespace plumb
