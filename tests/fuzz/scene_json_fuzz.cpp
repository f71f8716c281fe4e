#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include "scenarios/scene/scene_json.h"

// The entry point for libFuzzer. Whatever the bytes are, the reader must either refuse them with std::invalid_argument
// or read them completely, and then the written text must read back to the same text. Anything else aborts, which the
// fuzzer reports.
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
