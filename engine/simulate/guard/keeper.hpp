#pragma once

#include "engine/simulate/guard/link.hpp"

namespace stepwire::guard {

/// Third process of a guarded loop. The guard starts it before it opens the devices. It sleeps until the
/// guard has ended. Where safe outputs are not noted within half a period from then on, it sets them. It
/// kills a loop that was stopped while it set them itself, and so keeps a device from others.
///
/// Guard and loop watch each other, but none of them acts where both are killed, or where the loop is killed
/// or stopped after it has ended a guard without a processor.
///
/// Does not return in the process of the keeper.
void start_keeper(Link& link);

}  // namespace stepwire::guard
