#pragma once

#include "blocks/cosimulation/fmu.hpp"
#include "engine/model/block/configure.hpp"

namespace stepwire {

/// Reads the values of `parameters` and tries the unit with them. Faults are refused with their line.
void configure_unit(Fmu& block, Configure& is, fmi::Mode mode);

}  // namespace stepwire
