#include "reports/study/study.h"

#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "reports/cli/command.h"
#include "reports/study/conduct.h"
#include "scenarios/catalog.h"

namespace plumb::commands::study {
namespace {

// A word for each study, with options of its own beside those that all have.
std::function<int()> attach(CLI::App& app) {
  struct Asked {
    const Study* study;
    StudyOptions options;
    std::function<nlohmann::ordered_json()> configuration;
  };
  const auto asked = std::make_shared<std::map<const CLI::App*, Asked>>();
  app.require_subcommand(1);
  for (const Study* study : Catalog<Study>::all()) {
    CLI::App* added = app.add_subcommand(study->name, study->about);
    added->footer("Examples:\n" + study->examples);
    Asked& one = (*asked)[added];
    one.study = study;
    one.configuration = study->attach(*added);
    one.options.attach_to(*added);
  }
  return [asked, &app] {
    const Asked& one = asked->at(app.get_subcommands().front());
    return conduct(*one.study, one.configuration(), one.options);
  };
}

const Catalog<Command>::Entry entry{
    {.name = "study",
     .about = "Carry out a study of many runs: resumable, in parts if wanted, each point in a process of its own",
     .examples = "  plumb study speed                   speed against accuracy\n"
                 "  plumb study speed --resume          go on after an interruption\n"
                 "  plumb study speed --shard 1/4       the first of four parts, for plumb merge\n",
     .attach = attach}};

}  // namespace
}  // namespace plumb::commands::study
