#include <fmt/core.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/cli/command_line.h"
#include "reports/find/kind.h"
#include "reports/run/scene_file.h"
#include "reports/run/selection.h"
#include "reports/system/files.h"
#include "scenarios/catalog.h"
#include "scenarios/scene/json_reader.h"

namespace plumb::commands::export_scene {
namespace {

struct Export {
  std::string scenario;
  std::string out;
  std::uint64_t seed = 1;
  bool force = false;
};

struct Contents {
  SceneFile file;
  std::vector<std::string> left_out;
};

constexpr std::string_view random = "random:";  // before the name of a scene that plumb find draws

// A case of the tracker and a scene file are written as they are.
Contents contents_of(const std::string& word, std::uint64_t seed) {
  if (word.starts_with(random)) return {{drawn(word.substr(random.size()), seed), {}}, {}};
  if (is_scene_file(word) || word.starts_with(std::string(tracker) + ":")) return {scene_file_of(word), {}};
  const Case exported = parse_case(word);
  StatedTruths stated = truths_of(exported);
  return {{*exported.scene, std::move(stated.truth)}, std::move(stated.left_out)};
}

int execute(const Export& options) {
  const std::string place = "--out: \"" + options.out + "\" ";
  if (!options.out.ends_with(".json"))
    throw std::invalid_argument(place + "must end in .json, so that plumb run recognises it");
  if (!options.force && std::filesystem::exists(options.out)) {
    throw std::invalid_argument(place + "exists already; --force replaces it");
  }
  const auto [contents, left_out] = contents_of(options.scenario, options.seed);
  NewFile file(options.out);
  file.write_all(write_scene(contents));
  file.put_in_place();
  fmt::print("{}\n", printable(options.out, options.out.npos));
  for (const std::string& reason : left_out) fmt::print("Without {}.\n", reason);
  return 0;
}

const Catalog<Command>::Entry entry{
    {.name = "export",
     .about = "Write a scenario as a scene file, to edit and to give to `plumb run`",
     .examples = "  plumb export bounce --out bounce.json                        with the family's defaults\n"
                 "  plumb export bounce:e=0.5 --out half.json                    one of its variants\n"
                 "  plumb export bounce:restitution=0.6,height=2 --out own.json  with parameters of your own\n"
                 "  plumb export tracker:box2d-76-ball-rests --out rests.json    a reported case, with its source\n"
                 "  plumb export random:heap/3 --seed 7 --out heap.json          a scene that plumb find draws\n",
     .attach = [](CLI::App& app) {
       const auto options = std::make_shared<Export>();
       app.add_option("scenario", options->scenario,
                      "NAME, NAME:LABEL, NAME:parameter=value,..., tracker:NAME or random:KIND/N")
           ->required()
           ->type_name("NAME");
       app.add_option("--out", options->out, "The file to write")->required()->type_name("FILE.json");
       app.add_option("--seed", options->seed, "Of random:KIND/N, as plumb find draws it")
           ->type_name("N")
           ->capture_default_str();
       app.add_flag("--force", options->force, "Replace an existing file");
       return [options] { return execute(*options); };
     }}};

}  // namespace
}  // namespace plumb::commands::export_scene
