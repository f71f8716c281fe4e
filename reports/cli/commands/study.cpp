#include "reports/study/study.h"

#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "reports/cli/command_line.h"
#include "reports/study/conduct.h"
#include "scenarios/catalog.h"

namespace plumb::commands::study {
namespace {

// A subcommand for each study, with its own options besides the common ones.
std::function<int()> attach(CLI::App& app) {
  struct Selected {
    const Study* study;
    StudyOptions options;
    std::function<nlohmann::ordered_json()> configuration;
  };
  const auto selected = std::make_shared<std::map<const CLI::App*, Selected>>();
  app.require_subcommand(1);
  for (const Study* study : Catalog<Study>::all()) {
    CLI::App* added = app.add_subcommand(study->name, study->about);
    added->footer("Examples:\n" + study->examples);
    Selected& one = (*selected)[added];
    one.study = study;
    one.configuration = study->attach(*added);
    one.options.attach_to(*added);
  }
  return [selected, &app] {
    const Selected& one = selected->at(app.get_subcommands().front());
    return conduct(*one.study, one.configuration(), one.options);
  };
}

const Catalog<Command>::Entry entry{
    {.name = "study",
     .about = "Run a study of many runs: resumable, in shards if wanted, each job in a process of its own",
     .examples = "  plumb study speed                   speed against accuracy\n"
                 "  plumb study speed --resume          continue after an interruption\n"
                 "  plumb study speed --shard 1/4       the first of four parts, for plumb merge\n",
     .attach = attach}};

}  // namespace
}  // namespace plumb::commands::study
