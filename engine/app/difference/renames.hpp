#pragma once

#include "engine/app/difference/facts.hpp"

namespace stepwire::difference {

/// Finds blocks, parameters and inputs that have another name in the second file. A name is matched by the
/// content of its definition and by its uses.
NewNames find_renames(const Fact& before, const Fact& after);

}  // namespace stepwire::difference
