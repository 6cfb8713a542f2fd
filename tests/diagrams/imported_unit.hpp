#pragma once

#include <cstdint>
#include <string>

#include "engine/model/plan/plan.hpp"

namespace stepwire {

/// A diagram whose one block, `unit`, is the unit of this file, with step, solver and events of another
/// diagram. `keys` are further keys of the block: "interface: model_exchange".
std::string text_with_unit(const diagram::Diagram& own, const std::string& file, const std::string& keys,
                           std::int64_t ticks);

/// The first number in which a run of such a diagram differs from that of the diagram whose unit it has;
/// empty if there is none. `exchanges`: the unit has model exchange as well.
std::string difference_of_unit(const plan::Plan& own, const plan::Plan& outer, bool exchanges,
                               std::int64_t ticks);

}  // namespace stepwire
