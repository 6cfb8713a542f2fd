#pragma once

#include <optional>
#include <string_view>

#include "engine/base/unit/unit.hpp"

namespace stepwire::unit {

/// Returns the unit of a single word, with prefix and exponent: "mm", "lbf", "degC", "%", "m2". Returns
/// std::nullopt for other words. Thread-safe.
std::optional<Unit> named_unit(std::string_view word);

}  // namespace stepwire::unit
