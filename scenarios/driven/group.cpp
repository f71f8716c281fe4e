#include "scenarios/group.h"

namespace plumb::scenarios::groups {
namespace {

const Catalog<ScenarioGroup>::Entry driven{
    {.name = "driven",
     .title = "driven",
     .stake = "Machines run at the wrong speed: belts, lifts, motors and cranks slip or force what they cannot."}};

}  // namespace
}  // namespace plumb::scenarios::groups
