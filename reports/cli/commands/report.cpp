#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "reports/cli/command_line.h"
#include "reports/cli/session.h"
#include "reports/gate/options.h"
#include "reports/gate/writers.h"
#include "reports/history/trends.h"
#include "reports/run/experiment.h"
#include "reports/run/selection.h"
#include "reports/study/conduct.h"
#include "reports/study/study.h"
#include "reports/system/terminal.h"
#include "reports/writers/pictures.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/json_reader.h"

namespace plumb::commands::report {
namespace {

struct Options {
  Session session;
  bool no_studies = false;
  bool svg = false;
  std::string preview;  // of which case; "": none
  std::string history;
};

void add_study(Report& report, nlohmann::ordered_json document) {
  report.studies.push_back(std::make_shared<const nlohmann::ordered_json>(std::move(document)));
}

void add_studies(Report& report, const Session& session) {
  const ProgressLine line(session.quiet ? ProgressLine::Kind::quiet : ProgressLine::Kind::usual);
  for (const Study* study : Catalog<Study>::all()) {
    const auto options = study->summary ? study->summary(session.engines) : std::nullopt;
    if (!options) continue;
    add_study(report, summary_document(*study, *options, session.jobs,
                                       [&](const std::string& key, std::size_t done, std::size_t of) {
                                         line.show(fmt::format("study {} [{}/{}] {}", study->name, done, of, key));
                                       }));
  }
}

// Of the first case that a word selects, whether the report has it or not.
Preview preview_of_case(const std::string& word, const Session& session) {
  Plan plan = select_plan({word}, false, session.engines);
  plan.cases.erase(plan.cases.begin() + 1, plan.cases.end());
  plan.dt = parse_dt(session.dt);
  plan.refine = session.refinement();
  plan.timed = false;
  return preview_of(run_experiment(plan, [](const std::string&, std::size_t, std::size_t) {}));
}

int report(const Options& options) {
  nlohmann::ordered_json history;
  if (!options.history.empty()) history = history_document(History::of(options.history));
  // Missing tools are reported before anything runs.
  if (options.svg) check_pictures();
  std::optional<Preview> preview;
  if (!options.preview.empty()) {
    check_preview();
    preview = preview_of_case(options.preview, options.session);
  }
  options.session.conduct("report", [&](Report& report) {
    if (auto changes = changes_since(GateOptions{}.baseline_file(), report)) add_study(report, std::move(*changes));
    if (options.no_studies) {
      report.command.emplace_back("--no-studies");
    } else {
      add_studies(report, options.session);
    }
    if (!history.is_null()) add_study(report, history);
  });
  const std::filesystem::path out = options.session.out;
  if (options.svg) take_pictures(out / "index.html", out / "svg");
  if (preview) {
    write_preview(*preview, out / "preview.gif");
    if (options.session.prints_text()) fmt::print("{}\n", printable((out / "preview.gif").string(), std::string::npos));
  }
  return 0;
}

const Catalog<Command>::Entry entry{
    {.name = "report",
     .about = "Run scenarios and studies and write the page; exit code 0 whatever it finds",
     .examples = "  plumb report                     page, JSON and CSV in out/, with a short form of each study\n"
                 "  plumb report bounce:e=0.5        some cases in place of the canonical ones\n"
                 "  plumb report --no-studies        in a second or two\n"
                 "  plumb report --out results       somewhere else\n"
                 "  plumb report --all --dt 1/120    every scenario, at half the step\n"
                 "  plumb report --svg               also each chart as an SVG, in out/svg\n"
                 "  plumb report --preview stacking:ten   also any case as an animation\n",
     .attach = [](CLI::App& app) {
       const auto options = std::make_shared<Options>();
       options->session.attach_to(app);
       app.add_option("--history", options->history, "Show a file of plumb history on the page")->type_name("FILE");
       app.add_flag("--no-studies", options->no_studies, "Leave out the short forms of the studies");
       app.add_flag("--svg", options->svg,
                    "Also write each chart as an SVG, in the output folder's svg/; needs Node.js");
       app.add_option("--preview", options->preview, "Also write a case as an animation, preview.gif; needs ffmpeg")
           ->type_name("NAME:LABEL");
       return [options] { return report(*options); };
     }}};

}  // namespace
}  // namespace plumb::commands::report
