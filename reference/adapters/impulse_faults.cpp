// The faults inside our engine: it is built as always, with the faulty method's name where the right one's was.

#include "reference/faults/engine/fault.h"

#include "reference/faults/fault.h"

namespace plumb {
namespace {

// Integrators show in a solver that leaves them the free motion.
Settings method_of(const impulse::Fault& fault) {
  Settings method{{fault.kind, fault.spoils}};
  if (fault.kind == "integrator") method["solver"] = "exact";
  return method;
}

std::vector<Fault> engine_faults() {
  std::vector<Fault> all;
  for (const impulse::Fault& fault : impulse::faults()) {
    all.push_back({.name = fault.name,
                   .about = fault.about,
                   .source = fault.source,
                   .method = method_of(fault),
                   .build = [kind = fault.kind, name = fault.name](const Scene& scene, const Settings& settings) {
                     Settings faulty = settings;
                     faulty[kind] = name;
                     return build_ours(scene, faulty);
                   }});
  }
  return all;
}

const Catalog<FaultSource>::Entry entry{{"engine", engine_faults}};

}  // namespace
}  // namespace plumb
