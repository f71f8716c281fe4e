#include "reports/cli/joined.h"

#include <stdexcept>

namespace plumb {
namespace {

std::string mistake_in(const Engine& engine) {
  if (engine.name.empty()) return "needs a name";
  if (engine.name.find_first_of(":,= ") != std::string::npos) return "must have a name without space, : , and =";
  if (!engine.stepping) return "does not state how it steps: Engine::stepping is empty";
  if (!engine.unsupported) return "does not say what it cannot run: Engine::unsupported is empty";
  return engine.build ? "" : "cannot be built: Engine::build is empty";
}

}  // namespace

void check_joined(std::span<const Engine* const> all) {
  const Engine* before = nullptr;
  for (const Engine* engine : all) {
    std::string mistake = mistake_in(*engine);
    if (before != nullptr && before->name == engine->name) mistake = "is there twice: each needs a name of its own";
    if (!mistake.empty()) throw std::invalid_argument("engine \"" + engine->name + "\" " + mistake);
    before = engine;
  }
}

}  // namespace plumb
