#pragma once

#include <string_view>

namespace stepwire::text {

/// True where `a` precedes `b` and consecutive digits compare as one number: "9-b" before "10-a".
bool naturally_less(std::string_view a, std::string_view b);

}  // namespace stepwire::text
