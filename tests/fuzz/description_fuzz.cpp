#include <cstdint>

#include "engine/base/fmi/description.hpp"
#include "engine/base/fmi/unit_error.hpp"

using namespace stepwire;

// Any text must give the description of a unit, or a UnitError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    fmi::read_description({reinterpret_cast<const char*>(data), size});
  } catch (const fmi::UnitError&) {
  }
  return 0;
}
