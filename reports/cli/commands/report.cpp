#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "reports/cli/command.h"
#include "reports/cli/session.h"
#include "reports/gate/options.h"
#include "reports/gate/writers.h"
#include "reports/history/trends.h"
#include "reports/run/experiment.h"
#include "reports/run/plan_selection.h"
#include "reports/run/selection.h"
#include "reports/study/conduct.h"
#include "reports/study/study.h"
#include "reports/system/terminal.h"
#include "reports/writers/pictures.h"
#include "scenarios/catalog.h"

namespace plumb::commands::report {
namespace {

struct Asked {
  Session session;
  bool no_studies = false;
  bool svg = false;
  std::string preview;  // of which case; "": none
  std::string history;
};

void add_study(Report& report, nlohmann::ordered_json document) {
  report.studies.push_back(std::make_shared<const nlohmann::ordered_json>(std::move(document)));
}

void add_studies(Report& report, int jobs) {
  const ProgressLine line;
  for (const Study* study : Catalog<Study>::all()) {
    if (!study->summary) continue;
    add_study(report, summary_document(*study, jobs, [&](const std::string& key, std::size_t done, std::size_t of) {
                line.show(fmt::format("study {} [{}/{}] {}", study->name, done, of, key));
              }));
  }
}

// The first case that a word means, whether the report has it or not.
Preview preview_of_case(const std::string& word, const Session& session) {
  Plan plan = select_plan({word}, false, session.engines);
  plan.cases.erase(plan.cases.begin() + 1, plan.cases.end());
  plan.dt = parse_dt(session.dt);
  plan.refine = session.converged;
  plan.timed = false;
  return preview_of(run_experiment(plan, [](const std::string&, std::size_t, std::size_t) {}));
}

int report(const Asked& asked) {
  nlohmann::ordered_json history;
  if (!asked.history.empty()) history = history_document(History::of(asked.history));
  // What is missing is said before anything runs.
  if (asked.svg) check_pictures();
  std::optional<Preview> preview;
  if (!asked.preview.empty()) {
    check_preview();
    preview = preview_of_case(asked.preview, asked.session);
  }
  asked.session.conduct("report", [&](Report& report) {
    GateOptions gate;
    gate.all = asked.session.all;
    if (auto changes = changes_since(gate.baseline_file(), report)) add_study(report, std::move(*changes));
    if (asked.no_studies) {
      report.command.emplace_back("--no-studies");
    } else {
      add_studies(report, asked.session.jobs);
    }
    if (!history.is_null()) add_study(report, history);
  });
  const std::filesystem::path out = asked.session.out;
  if (asked.svg) take_pictures(out / "index.html", out / "svg");
  if (preview) {
    write_preview(*preview, out / "preview.gif");
    fmt::print("{}\n", (out / "preview.gif").string());
  }
  return 0;
}

const Catalog<Command>::Entry entry{
    {.name = "report",
     .about = "Run everything and write the page to look at; exit code 0 whatever it finds",
     .examples = "  plumb report                     page, JSON and CSV in out/, with a short form of each study\n"
                 "  plumb report --no-studies        in a second or two\n"
                 "  plumb report --out results       somewhere else\n"
                 "  plumb report --all --dt 1/120    every scenario, at half the step\n"
                 "  plumb report --svg               also each chart as an SVG, in out/svg\n"
                 "  plumb report --preview stacking:ten   also a case, of these or not, as a moving picture\n",
     .attach = [](CLI::App& app) {
       const auto asked = std::make_shared<Asked>();
       asked->session.attach_to(app);
       app.add_option("--history", asked->history, "A file of plumb history, to be shown on the page")
           ->type_name("FILE");
       app.add_flag("--no-studies", asked->no_studies, "Leave out the short forms of the studies");
       app.add_flag("--svg", asked->svg, "Also write each chart as an SVG, in the output folder's svg/; needs Node.js");
       app.add_option("--preview", asked->preview, "Also write a case as a moving picture, preview.gif; needs ffmpeg")
           ->type_name("NAME:LABEL");
       return [asked] { return report(*asked); };
     }}};

}  // namespace
}  // namespace plumb::commands::report
