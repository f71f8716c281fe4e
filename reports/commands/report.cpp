#include <memory>

#include "reports/command.h"
#include "reports/session.h"
#include "scenarios/catalog.h"

namespace plumb {
namespace {

int report(const Session& session) {
  session.conduct("report");
  return 0;
}

const Catalog<Command>::Entry entry{
    {.name = "report",
     .about = "Run everything and write the page to look at; exit code 0 whatever it finds",
     .examples = "  plumb report                     page, JSON and CSV in out/\n"
                 "  plumb report --out results       somewhere else\n"
                 "  plumb report --all --dt 1/120    every scenario, at half the step\n",
     .attach = [](CLI::App& app) {
       const auto session = std::make_shared<Session>();
       session->attach_to(app);
       return [session] { return report(*session); };
     }}};

}  // namespace
}  // namespace plumb
