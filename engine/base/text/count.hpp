#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace stepwire::text {

/// Returns a number with its noun, whose plural ends in s: "1 row", "3 rows", "0 rows".
std::string counted(std::int64_t count, std::string_view noun);
/// Returns the same as the begin of a sentence: "there is 1 name", "there are 3 names".
std::string there_are(std::int64_t count, std::string_view noun);

/// Casts other integers, such as sizes.
template <class Integer>
std::string counted(Integer count, std::string_view noun) {
  return counted(static_cast<std::int64_t>(count), noun);
}
template <class Integer>
std::string there_are(Integer count, std::string_view noun) {
  return there_are(static_cast<std::int64_t>(count), noun);
}

}  // namespace stepwire::text
