#include "reports/writers/html.h"

namespace plumb {

std::string_view page_template() { return {}; }
std::string_view picture_program() { return {}; }

}  // namespace plumb
