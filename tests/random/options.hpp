#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace stepwire::random {

/// Options of the program.
struct Options {
  std::uint64_t seed = 1;
  std::size_t count = 300;
  std::size_t with_code = std::numeric_limits<std::size_t>::max();  ///< diagrams of each `count`
  bool forever = false, show = false, shrinks = true, help = false;
  std::string out = "random-failures";
};

/// Reads a command line without the name of the program. Throws std::invalid_argument with a sentence.
Options read_options(int count, const char* const* arguments);

/// Text of --help.
std::string help_text();

}  // namespace stepwire::random
