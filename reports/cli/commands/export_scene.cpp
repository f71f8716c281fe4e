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

int carry_out(const Export& asked) {
  const std::string place = "--out: \"" + asked.out + "\" ";
  if (!asked.out.ends_with(".json")) throw std::invalid_argument(place + "must end in .json, for plumb run to know it");
  if (!asked.force && std::filesystem::exists(asked.out)) {
    throw std::invalid_argument(place + "is there already; --force replaces it");
  }
  const Case exported = parse_case(asked.scenario);
  const StatedTruths stated = truths_of(exported);
  NewFile file(asked.out);
  if (!file.write(write_scene({*exported.scene, stated.truth})))
    throw std::invalid_argument(place + "cannot be written");
  file.put_in_place();
  fmt::print("{}\n", asked.out);
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
       const auto asked = std::make_shared<Export>();
       app.add_option("scenario", asked->scenario, "NAME, NAME:LABEL or NAME:parameter=value,...")
           ->required()
           ->type_name("NAME");
       app.add_option("--out", asked->out, "The file to write")->required()->type_name("FILE.json");
       app.add_flag("--force", asked->force, "Replace the file if it is there");
       return [asked] { return carry_out(*asked); };
     }}};

}  // namespace
}  // namespace plumb::commands::export_scene
