#include "scenarios/group.h"

namespace plumb::scenarios::groups {
namespace {

const Catalog<ScenarioGroup>::Entry contact{
    {.name = "contact",
     .title = "contact",
     .stake = "Discs hop at seams, things sink into slopes or fly off edges where they should slide."}};

}  // namespace
}  // namespace plumb::scenarios::groups
