#pragma once

#include <string_view>

namespace plumb {

/// The page, ready but for its data: the one `<!--plumb-data-->` in it is where
/// `<script type="application/json" id="plumb-data">{"report": ..., "series": ..., "studies": [...]}</script>` goes.
/// Empty in a build that had no Node.js 18 or could not get the page's npm packages.
std::string_view page_template();

}  // namespace plumb
