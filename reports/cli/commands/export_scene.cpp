#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <stdexcept>

#include "reports/cli/command.h"
#include "reports/run/scene_file.h"
#include "reports/run/selection.h"
#include "reports/system/files.h"
#include "scenarios/catalog.h"

namespace plumb::commands::export_scene {
namespace {

struct Export {
  std::string scenario;
  std::string out;
  bool force = false;
};

int execute(const Export& options) {
  const std::string place = "--out: \"" + options.out + "\" ";
  if (!options.out.ends_with(".json"))
    throw std::invalid_argument(place + "must end in .json, so that plumb run recognises it");
  if (!options.force && std::filesystem::exists(options.out)) {
    throw std::invalid_argument(place + "exists already; --force replaces it");
  }
  const Case exported = parse_case(options.scenario);
  const StatedTruths stated = truths_of(exported);
  NewFile file(options.out);
  if (!file.write(write_scene({*exported.scene, stated.truth})))
    throw std::invalid_argument(place + "cannot be written");
  file.put_in_place();
  fmt::print("{}\n", options.out);
  for (const std::string& reason : stated.left_out) fmt::print("Without {}.\n", reason);
  return 0;
}

const Catalog<Command>::Entry entry{
    {.name = "export",
     .about = "Write a scenario as a scene file, to edit and to give to `plumb run`",
     .examples = "  plumb export bounce --out bounce.json                        with the family's defaults\n"
                 "  plumb export bounce:e=0.5 --out half.json                    one of its variants\n"
                 "  plumb export bounce:restitution=0.6,height=2 --out own.json  with parameters of your own\n",
     .attach = [](CLI::App& app) {
       const auto options = std::make_shared<Export>();
       app.add_option("scenario", options->scenario, "NAME, NAME:LABEL or NAME:parameter=value,...")
           ->required()
           ->type_name("NAME");
       app.add_option("--out", options->out, "The file to write")->required()->type_name("FILE.json");
       app.add_flag("--force", options->force, "Replace an existing file");
       return [options] { return execute(*options); };
     }}};

}  // namespace
}  // namespace plumb::commands::export_scene
