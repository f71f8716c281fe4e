#include <algorithm>
#include <memory>

#include "reports/cli/command_line.h"
#include "reports/cli/session.h"
#include "scenarios/catalog.h"

namespace plumb::commands::run {
namespace {

int run(const Session& session) {
  const Report report = session.conduct("run");
  const bool broken = std::any_of(report.runs.begin(), report.runs.end(), [](const RunRecord& record) {
    return record.verdict == Verdict::wrong || record.verdict == Verdict::failed;
  });
  return broken ? 1 : 0;
}

const Catalog<Command>::Entry entry{
    {.name = "run",
     .about = "Run scenarios and judge the engines; exit code 1 if one is wrong or fails",
     .examples = "  plumb run                                  the canonical scenarios, every engine\n"
                 "  plumb run bounce                           every variant of one scenario\n"
                 "  plumb run bounce:restitution=0.5           one with a parameter of your own\n"
                 "  plumb run mine.json                        a scene file of your own (see plumb export)\n"
                 "  plumb run tracker                          what users of engines reported (plumb list tracker)\n"
                 "  plumb run slope --engine box2d --dt 1/240  one engine, a smaller step\n"
                 "  plumb run --engine impulse --engine impulse:integrator=rk4   two methods compared\n",
     .attach = [](CLI::App& app) {
       const auto session = std::make_shared<Session>();
       session->attach_to(app);
       return [session] { return run(*session); };
     }}};

}  // namespace
}  // namespace plumb::commands::run
