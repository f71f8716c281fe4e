#include "scenarios/group.h"

namespace plumb::scenarios::groups {
namespace {

const Catalog<ScenarioGroup>::Entry joints{
    {.name = "joints",
     .title = "joints",
     .stake = "Ropes stretch, hinges drift apart, pendulums die out or swing up by themselves."}};

}  // namespace
}  // namespace plumb::scenarios::groups
