#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/unit/unit.hpp"

namespace stepwire::language {

/// Unit as written in files, and the name of its quantity.
struct KnownUnit {
  std::string name, of;
};

/// Returns common units of a dimension, or of all if it is unknown. The SI unit is always included for a
/// known dimension.
std::vector<KnownUnit> units_of(const std::optional<unit::Dimension>& dimension);

}  // namespace stepwire::language
