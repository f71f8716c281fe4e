#include <fmt/format.h>

#include <memory>

#include "reports/command.h"
#include "reports/progress_line.h"
#include "reports/session.h"
#include "reports/study.h"
#include "reports/study/brief.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

struct Asked {
  Session session;
  bool no_studies = false;
};

void add_studies(Report& report, int jobs) {
  const ProgressLine line;
  for (const Study* study : Catalog<Study>::all()) {
    if (!study->brief) continue;
    report.studies.push_back(
        brief_document(*study, jobs, [&](const std::string& key, std::size_t done, std::size_t of) {
          line.show(fmt::format("study {} [{}/{}] {}", study->name, done, of, key));
        }));
  }
}

int report(const Asked& asked) {
  asked.session.conduct("report", [&](Report& report) {
    if (asked.no_studies) {
      report.command.emplace_back("--no-studies");
    } else {
      add_studies(report, asked.session.jobs);
    }
  });
  return 0;
}

const Catalog<Command>::Entry entry{
    {.name = "report",
     .about = "Run everything and write the page to look at; exit code 0 whatever it finds",
     .examples = "  plumb report                     page, JSON and CSV in out/, with a short form of each study\n"
                 "  plumb report --no-studies        in a second or two\n"
                 "  plumb report --out results       somewhere else\n"
                 "  plumb report --all --dt 1/120    every scenario, at half the step\n",
     .attach = [](CLI::App& app) {
       const auto asked = std::make_shared<Asked>();
       asked->session.attach_to(app);
       app.add_flag("--no-studies", asked->no_studies, "Leave out the short forms of the studies");
       return [asked] { return report(*asked); };
     }}};

}  // namespace
}  // namespace plumb
