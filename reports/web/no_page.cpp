#include "reports/writers/page.h"

namespace plumb {

std::string_view page_template() { return {}; }

}  // namespace plumb
