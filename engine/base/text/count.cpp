#include "engine/base/text/count.hpp"

#include <fmt/format.h>

namespace stepwire::text {

std::string counted(std::int64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string there_are(std::int64_t count, std::string_view noun) {
  return fmt::format("there {} {}", count == 1 ? "is" : "are", counted(count, noun));
}

}  // namespace stepwire::text
