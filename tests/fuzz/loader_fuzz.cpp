#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/document/document.hpp"

// Any text must give a tree or an Error; anything else that is thrown ends the program, and that is a find.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    stepwire::parse_document(text, "fuzz.yaml");
  } catch (const stepwire::Error&) {
  }
  return 0;
}
