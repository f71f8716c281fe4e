#include "scenarios/group.h"

namespace plumb::scenarios::groups {
namespace {

const Catalog<ScenarioGroup>::Entry friction{
    {.name = "friction",
     .title = "friction",
     .stake = "Boxes creep down slopes that should hold them, wheels slip, brakes stop too early or too late."}};

}  // namespace
}  // namespace plumb::scenarios::groups
