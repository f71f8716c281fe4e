#include "reports/find/again.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "reports/find/finding.h"
#include "reports/find/isolated.h"
#include "reports/find/tables.h"
#include "reports/system/files.h"
#include "reports/writers/junit.h"
#include "reports/writers/output.h"
#include "scenarios/scene/scene_json.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;

// In the order of their names.
std::vector<fs::path> scenes_in(const std::string& folder) {
  if (!fs::is_directory(folder)) throw std::invalid_argument(folder + ": is not a folder");
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  if (files.empty()) throw std::invalid_argument(folder + ": has no scene files; plumb find writes them to OUT/found");
  std::ranges::sort(files);
  return files;
}

}  // namespace

int run_again(const std::string& folder, const std::vector<std::string>& words, bool chosen, const std::string& out,
              double run_limit) {
  const std::vector<fs::path> files = scenes_in(folder);
  const OutputFolder into(out);
  const RunLimits limits{.seconds = run_limit};
  std::vector<TestCase> cases;
  std::vector<std::vector<std::string>> rows{{"scene", "engine", "what"}};
  int failed = 0;
  for (const fs::path& file : files) {
    const Scene scene = read_scene(read_text(file.string(), largest_scene_file), file.string()).scene;
    const Origin origin = origin_of(scene);
    const std::string found_in = origin.engine.empty() ? "impulse" : origin.engine;
    const std::vector<Suspect> suspects = parse_suspects(chosen ? words : std::vector{found_in});
    const std::vector<Opinion> opinions = judged_apart(scene, origin.posed, suspects, {}, limits);
    for (std::size_t i = 0; i < suspects.size(); ++i) {
      const Suspect& suspect = suspects[i];
      const Opinion& opinion = opinions[i];
      std::string failure;
      for (const Complaint& one : opinion.complaints) failure += (failure.empty() ? "" : "; ") + one.words();
      failed += failure.empty() ? 0 : 1;
      cases.push_back({file.stem().string(), suspect.name, failure});
      rows.push_back({file.stem().string(), suspect.name,
                      !failure.empty()         ? failure
                      : opinion.status == "ok" ? "holds"
                                               : "not supported"});
    }
  }
  const std::string verdict = fmt::format("{} of {} fail.\n", failed, cases.size());
  const auto paths = into.put({{"again.md", "### Plumb: find --again\n\n" + verdict + "\n" + markdown_table(rows)},
                               {"again.xml", junit("plumb find --again", cases)}});
  fmt::print("{}\n{}", plain_table(rows), verdict);
  for (const auto& path : paths) fmt::print("{}\n", path.string());
  return failed > 0 ? 1 : 0;
}

}  // namespace plumb
