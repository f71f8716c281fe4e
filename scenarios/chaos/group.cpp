#include "scenarios/group.h"

namespace plumb::scenarios::groups {
namespace {

const Catalog<ScenarioGroup>::Entry chaos{
    {.name = "chaos",
     .title = "chaos and statistics",
     .stake = "No single run can be checked, so a wrong crowd, gas or heap passes unseen: only its statistics tell."}};

}  // namespace
}  // namespace plumb::scenarios::groups
