#include <iostream>

#include "reports/command.h"
#include "reports/gate/timing_pace.h"
#include "scenarios/catalog.h"

namespace plumb {
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
}  // namespace plumb
