#include <memory>
#include <string>
#include <vector>

#include "reports/cli/command_line.h"
#include "reports/study/document.h"
#include "scenarios/catalog.h"

namespace plumb::commands::merge_command {
namespace {

struct Merge {
  std::vector<std::string> files;
  std::string out = "out";
};

int execute(const Merge& options) {
  const OutputFolder folder(options.out);
  return merge_shards({options.files.begin(), options.files.end()}, folder);
}

const Catalog<Command>::Entry entry{
    {.name = "merge",
     .about = "Put the shards of a study together",
     .examples = "  plumb merge out/study-speed-*-of-4.jsonl --out merged\n",
     .attach = [](CLI::App& app) {
       const auto options = std::make_shared<Merge>();
       app.add_option("files", options->files, "The results files of all shards")->required()->type_name("FILE");
       app.add_option("--out", options->out, "Folder for study-NAME.json, .csv and .html")
           ->capture_default_str()
           ->type_name("DIR");
       return [options] { return execute(*options); };
     }}};

}  // namespace
}  // namespace plumb::commands::merge_command
