#include "scenarios/group.h"

namespace plumb::scenarios::groups {
namespace {

const Catalog<ScenarioGroup>::Entry impact{
    {.name = "impact",
     .title = "impact",
     .stake = "Balls bounce too high or pass through walls; who wins a break shot depends on the order of a list."}};

}  // namespace
}  // namespace plumb::scenarios::groups
