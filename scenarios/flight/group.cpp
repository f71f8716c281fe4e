#include "scenarios/group.h"

namespace plumb::scenarios::groups {
namespace {

const Catalog<ScenarioGroup>::Entry flight{
    {.name = "flight",
     .title = "flight",
     .stake = "Throws land elsewhere at another frame rate, orbits spiral away, spinning bodies gain energy."}};

}  // namespace
}  // namespace plumb::scenarios::groups
