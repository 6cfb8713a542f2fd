#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/unit/unit.hpp"

namespace stepwire::language {

/// A unit as people write it, and what it is one of.
struct KnownUnit {
  std::string name, of;
};

/// Usual units of a dimension, or of any; that of SI is always among them.
std::vector<KnownUnit> units_of(const std::optional<unit::Dimension>& dimension);

}  // namespace stepwire::language
