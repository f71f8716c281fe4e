#include "scenarios/scenario.h"

namespace plumb::scenarios::groups {
namespace {

const Catalog<ScenarioGroup>::Entry flight{
    {.name = "flight",
     .title = "flight",
     .stake = "Throws land elsewhere at another frame rate, orbits spiral away, spinning bodies gain energy."}};

const Catalog<ScenarioGroup>::Entry contact{
    {.name = "contact",
     .title = "contact",
     .stake = "Discs hop at seams, things sink into slopes or fly off edges where they should slide."}};

const Catalog<ScenarioGroup>::Entry friction{
    {.name = "friction",
     .title = "friction",
     .stake = "Boxes creep down slopes that should hold them, wheels slip, brakes stop too early or too late."}};

const Catalog<ScenarioGroup>::Entry impact{
    {.name = "impact",
     .title = "impact",
     .stake = "Balls bounce too high or pass through walls; who wins a break shot depends on the order of a list."}};

const Catalog<ScenarioGroup>::Entry stacks{
    {.name = "stacks",
     .title = "stacks",
     .stake = "Towers lean and walls explode or sink, and a scene that should sleep never comes to rest."}};

const Catalog<ScenarioGroup>::Entry joints{
    {.name = "joints",
     .title = "joints",
     .stake = "Ropes stretch, hinges drift apart, pendulums die out or swing up by themselves."}};

const Catalog<ScenarioGroup>::Entry driven{
    {.name = "driven",
     .title = "driven",
     .stake = "Machines run at the wrong speed: belts, lifts, motors and cranks slip or force what they cannot."}};

const Catalog<ScenarioGroup>::Entry chaos{
    {.name = "chaos",
     .title = "chaos and statistics",
     .stake = "No single run can be checked, so a wrong crowd, gas or heap passes unseen: only its statistics tell."}};

}  // namespace
}  // namespace plumb::scenarios::groups
