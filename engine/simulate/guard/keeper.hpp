#pragma once

#include <sys/types.h>

#include "engine/simulate/guard/link.hpp"

namespace stepwire::guard {

/// Third process of a guarded loop. The guard starts it before it opens the devices. It sleeps until the
/// guard has ended. Where safe outputs are not noted within half a period from then on, it sets them. It
/// kills a loop that was stopped while it set them itself, and so keeps a device from others.
///
/// Guard and loop watch each other, but none of them acts where both are killed, or where the loop is killed
/// or stopped after it has ended a guard without a processor.
///
/// A driver that does not return from open or start within 10 s, or from another call within 2 s, ends the
/// keeper with a sentence.
///
/// Does not return in the process of the keeper. Returns its process in the guard.
pid_t start_keeper(Link& link);

/// True once the keeper, a child of this process, has ended or is stopped. Takes less than a microsecond.
bool is_lost(pid_t keeper) noexcept;

}  // namespace stepwire::guard
