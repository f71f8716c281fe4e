#include "reports/joined.h"

#include <stdexcept>

namespace plumb {
namespace {

std::string mistake_in(const Contender& contender) {
  if (contender.name.empty()) return "needs a name";
  if (contender.name.find_first_of(":,= ") != std::string::npos) return "must have a name without space, : , and =";
  if (!contender.stepping) return "does not state how it steps: Contender::stepping is empty";
  if (!contender.unsupported) return "does not say what it cannot run: Contender::unsupported is empty";
  return contender.build ? "" : "cannot be built: Contender::build is empty";
}

}  // namespace

void check_joined(std::span<const Contender* const> all) {
  const Contender* before = nullptr;
  for (const Contender* contender : all) {
    std::string mistake = mistake_in(*contender);
    if (before != nullptr && before->name == contender->name) mistake = "is there twice: each needs a name of its own";
    if (!mistake.empty()) throw std::invalid_argument("engine \"" + contender->name + "\" " + mistake);
    before = contender;
  }
}

}  // namespace plumb
