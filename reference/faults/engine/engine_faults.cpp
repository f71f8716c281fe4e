// The faults inside our engine: it is built as usual, with the faulty method's name in place of the right one's.

#include "reference/faults/engine/fault.h"

#include "reference/faults/altered_engine.h"

namespace plumb {
namespace {

// An integrator takes effect only in a solver that leaves it the free motion.
Settings method_of(const impulse::Fault& fault) {
  Settings method{{fault.kind, fault.mutates}};
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
