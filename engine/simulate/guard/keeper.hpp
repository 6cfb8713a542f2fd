#pragma once

#include "engine/simulate/guard/link.hpp"

namespace stepwire::guard {

/// Third process of a guarded loop. The guard starts it before it opens the devices. It sleeps until both the
/// guard and the loop have ended; where neither has noted safe outputs by then, it sets them.
///
/// Guard and loop watch each other, but none of them is left where both are killed, or where the loop is
/// killed after it has ended a guard without a processor.
///
/// `life` is this side's end of the loop's socket. Does not return in the process of the keeper.
void start_keeper(Link& link, int life);

}  // namespace stepwire::guard
