#include "scenarios/group.h"

namespace plumb::scenarios::groups {
namespace {

const Catalog<ScenarioGroup>::Entry stacks{
    {.name = "stacks",
     .title = "stacks",
     .stake = "Towers lean and walls explode or sink, and a scene that should sleep never comes to rest."}};

}  // namespace
}  // namespace plumb::scenarios::groups
