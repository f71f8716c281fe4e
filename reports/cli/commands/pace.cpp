#include <iostream>

#include "reports/cli/command.h"
#include "reports/timing/pace.h"
#include "scenarios/catalog.h"

namespace plumb::commands::pace_command {
namespace {

const Catalog<Command>::Entry entry{{.name = "pace",
                                     .about = "Step scenes on request, for plumb check --time-against",
                                     .examples = "  plumb check --time-against build/base/reports/plumb\n",
                                     .attach = [](CLI::App& app) {
                                       app.group("");  // for programs, not for people
                                       return [] {
                                         pace(std::cin, std::cout);
                                         return 0;
                                       };
                                     }}};

}  // namespace
}  // namespace plumb::commands::pace_command
