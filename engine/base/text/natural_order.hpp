#pragma once

#include <string_view>

namespace stepwire::text {

/// True where `a` comes before `b` and digits in a row count as one number: "9-b" before "10-a".
bool naturally_less(std::string_view a, std::string_view b);

}  // namespace stepwire::text
