#include <memory>
#include <string>
#include <vector>

#include "reports/cli/command.h"
#include "reports/study/document.h"
#include "scenarios/catalog.h"

namespace plumb::commands::merge_command {
namespace {

struct Merge {
  std::vector<std::string> files;
  std::string out = "out";
};

int carry_out(const Merge& asked) {
  const OutputFolder folder(asked.out);
  merge_shards({asked.files.begin(), asked.files.end()}, folder);
  return 0;
}

const Catalog<Command>::Entry entry{
    {.name = "merge",
     .about = "Put the shards of a study together",
     .examples = "  plumb merge out/study-speed-*-of-4.jsonl --out merged\n",
     .attach = [](CLI::App& app) {
       const auto asked = std::make_shared<Merge>();
       app.add_option("files", asked->files, "The results of every shard")->required()->type_name("FILE");
       app.add_option("--out", asked->out, "Folder for study-NAME.json, .csv and .html")
           ->capture_default_str()
           ->type_name("DIR");
       return [asked] { return carry_out(*asked); };
     }}};

}  // namespace
}  // namespace plumb::commands::merge_command
