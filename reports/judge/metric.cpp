#include "reports/judge/metric.h"

#include "scenarios/catalog.h"

namespace plumb {

const char* name_of(Better better) {
  switch (better) {
    case Better::lower:
      return "lower";
    case Better::higher:
      return "higher";
    case Better::neither:
      return "neither";
  }
  return "";
}

std::map<std::string, Measured> measure(const MetricContext& context) {
  std::map<std::string, Measured> measured;
  for (const Metric* metric : Catalog<Metric>::all()) {
    if (const auto value = metric->measure(context)) measured[metric->name] = {*value, metric->unit};
  }
  return measured;
}

}  // namespace plumb
