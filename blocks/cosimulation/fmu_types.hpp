#pragma once

#include <string>

#include "engine/model/block/block_type.hpp"

namespace stepwire {

/// What all of them have in common, which is no unit's.
BlockType any_fmu_type();

/// The type of blocks of a unit: `word` is co_simulation, model_exchange, or anything else for the interface
/// that the unit has, co-simulation where it has both. Throws fmi::UnitError.
const BlockType& fmu_type(const std::string& file, const std::string& word);

}  // namespace stepwire
