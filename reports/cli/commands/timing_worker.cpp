#include "reports/timing/worker.h"

#include <iostream>
#include <memory>
#include <stdexcept>

#include "reports/cli/command_line.h"
#include "reports/run/selection.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/scene_json.h"

namespace plumb::commands::timing_worker {
namespace {

FreshSimulation simulation_of(const std::string& text, const std::string& words) {
  const auto scene = std::make_shared<const Scene>(read_scene(text, "scene").scene);
  const EngineConfig config = parse_engine("in-process:" + words);  // this process is there for it alone
  const std::string unsupported = config.engine->unsupported(*scene, config.settings);
  if (!unsupported.empty()) throw std::invalid_argument(unsupported);
  return [scene, config] { return config.engine->build(*scene, config.settings); };
}

std::function<int()> attach(CLI::App& app) {
  app.group("");  // hidden: programs run it, not people
  return [] {
    serve_timing(std::cin, std::cout, simulation_of);
    return 0;
  };
}

const Catalog<Command>::Entry entry{{.name = "timing-worker",
                                     .about = "Step scenes on request, for plumb check --time-against",
                                     .examples = "  plumb check --time-against build/base/reports/plumb\n",
                                     .attach = attach}};

// The name by which builds from before it was renamed start it.
const Catalog<Command>::Entry old_name{{.name = "pace",
                                        .about = "The old name of timing-worker",
                                        .examples = "  plumb check --time-against build/base/reports/plumb\n",
                                        .attach = attach}};

}  // namespace
}  // namespace plumb::commands::timing_worker
