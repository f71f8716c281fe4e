// Our own engine, on the same terms as its rivals: public headers only, its own defaults.
//
// What this engine does differently is stated by each of its methods (impulse::stated_errors); this file only chooses
// the precision and hands over to impulse_world.cpp, compiled once for each.

#include "reference/adapters/impulse_world.h"

namespace plumb {
namespace {

const Contender& self() { return *Catalog<Contender>::find("impulse"); }

ImpulseEngine in_precision_of(const Settings& settings) {
  return settings.at("precision") == "float" ? single_precision::impulse_engine() : double_precision::impulse_engine();
}

Contender impulse() {
  Contender contender;
  contender.name = "impulse";
  contender.about = "our own engine";
  contender.source = "this repository, engine/";
  contender.options = double_precision::impulse_engine().options();
  contender.options.push_back(
      {.key = "precision",
       .value = "double",
       .choices = {{"float", "single precision, as games run it"}, {"double", "double precision"}},
       .about = "arithmetic"});
  contender.also = {{{"solver", "article"}}};
  contender.stepping = [](const Settings& given, double dt) {
    const Settings settings = complete(self(), given);
    return in_precision_of(settings).stepping(settings, dt);
  };
  contender.unsupported = [](const Scene& scene, const Settings& given) {
    const Settings settings = complete(self(), given);
    return in_precision_of(settings).unsupported(scene, settings);
  };
  contender.build = [](const Scene& scene, const Settings& given) {
    const Settings settings = complete(self(), given);
    return in_precision_of(settings).build(scene, settings);
  };
  return contender;
}

const Catalog<Contender>::Entry entry{impulse};

}  // namespace
}  // namespace plumb
