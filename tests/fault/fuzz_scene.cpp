#include <cstddef>
#include <cstdint>

#include "support/scene_reading.hpp"

/// What libFuzzer calls with each of its inputs (`make fuzz`).
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  talus::support::read_as_scene({reinterpret_cast<const char*>(data), size});
  return 0;
}
