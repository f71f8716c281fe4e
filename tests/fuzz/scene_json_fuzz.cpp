#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include "scenarios/scene/scene_json.h"

// libFuzzer's entry. Whatever the bytes: refused by std::invalid_argument, or read whole, and then what is written can
// be read and is written the same. Anything else ends the program, which the fuzzer reports.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::SceneFile read;
  try {
    read = plumb::read_scene({reinterpret_cast<const char*>(data), size}, "fuzz.json");
  } catch (const std::invalid_argument&) {
    return 0;
  }
  const std::string text = plumb::write_scene(read);
  if (plumb::write_scene(plumb::read_scene(text, "written.json")) != text) std::abort();
  return 0;
}
