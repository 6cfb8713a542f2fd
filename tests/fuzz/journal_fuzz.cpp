#include <cstdlib>

#include "engine/base/io/environment_error.hpp"
#include "engine/simulate/journal/byte_journal.hpp"
#include "tests/fuzz/input_file.hpp"

using namespace stepwire;

// Any bytes may follow the first line. The journal opens, and returns the pieces that has() is true for, and
// no others.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static fuzz::InputFile file(".journal");
  constexpr std::size_t pieces = 16;
  try {
    const std::string path = file.with(data, size);
    const std::string head = journal::ByteJournal::head_of(path).value_or("");
    journal::ByteJournal journal(path, head, pieces, journal::ByteJournal::Use::read);
    for (std::size_t piece = 0; piece < pieces; ++piece)
      if (journal.bytes(piece).has_value() != journal.has(piece)) std::abort();
  } catch (const io::EnvironmentError&) {
  }
  return 0;
}
