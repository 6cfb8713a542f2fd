#pragma once

#include <optional>
#include <string_view>

#include "engine/base/unit/unit.hpp"

namespace stepwire::unit {

/// The unit that is one word, prefix and exponent included: "mm", "lbf", "degC", "%", "m2"; nothing if the
/// word is none. Safe from several threads.
std::optional<Unit> named_unit(std::string_view word);

}  // namespace stepwire::unit
