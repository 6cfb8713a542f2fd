#pragma once

#include <string>

#include "engine/model/block/block_type.hpp"

namespace stepwire {

/// Returns the type with the common properties of all FMUs, without a unit.
BlockType any_fmu_type();

/// Returns the block type of a unit. `word` is co_simulation or model_exchange. Any other text selects the
/// interface that the unit has (co-simulation if it has both). Throws fmi::UnitError.
const BlockType& fmu_type(const std::string& file, const std::string& word);

}  // namespace stepwire
