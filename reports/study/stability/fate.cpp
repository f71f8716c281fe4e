#include "reports/study/stability/fate.h"

#include <array>

namespace plumb {
namespace {

constexpr std::array<FateText, 10> all_fates{{
    {Fate::not_supported, '-', "not supported", "the method cannot run the scene"},
    {Fate::holds, 'h', "holds", "none of the others"},
    {Fate::drifts, 'd', "drifts", "a body leaves its place, or goes on moving the same way"},
    {Fate::jitters, 'j', "jitters", "a body stays about its place but does not come to rest"},
    {Fate::sinks, 's', "sinks", "bodies reach into each other, or a joint gives way"},
    {Fate::tunnels, 't', "tunnels", "a body is behind a wall and was in it at no step's end"},
    {Fate::topples, 'o', "topples", "a body turns over or comes down"},
    {Fate::gains_energy, 'g', "gains energy", "the scene has more energy than it can have"},
    {Fate::diverges, 'x', "diverges", "a number is not finite or absurd: above 1e7 m, 1e6 m/s or 1e6 rad/s"},
    {Fate::fails, 'e', "fails", "the engine threw an error"},
}};

const FateText& text_of(Fate fate) { return all_fates[static_cast<std::size_t>(fate)]; }

}  // namespace

std::span<const FateText> fates() { return all_fates; }
char letter_of(Fate fate) { return text_of(fate).letter; }
const char* name_of(Fate fate) { return text_of(fate).name; }
bool is_failure(Fate fate) { return fate != Fate::holds && fate != Fate::not_supported; }

}  // namespace plumb
