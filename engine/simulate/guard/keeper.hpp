#pragma once

#include <sys/types.h>

#include "engine/simulate/guard/link.hpp"

namespace stepwire::guard {

/// Third process of a guarded loop. The guard starts it before it opens the devices. It waits for the end of
/// the guard. Where safe outputs are not noted within half a period from then on, it sets them. It kills a
/// loop that was stopped while it set them itself, and so keeps a device from others.
///
/// Guard and loop watch each other, but none of them acts where both are killed or stopped, or where the loop
/// is killed or stopped after it has ended a guard without a processor.
///
/// The keeper kills a guard whose outputs follow the loop and that has not read the devices for 0.1 s more
/// than the loop may be late. A loop that runs ends such a guard before. Where the guard writes the safe
/// values, the time is 2.5 s, since a driver may be slow there. Time in which the keeper itself does not run
/// counts as two of its looks at most, so a pause of the machine does not count.
///
/// A driver that does not return from open or start within 10 s, or from another call within 2 s, ends the
/// keeper with a sentence.
///
/// Does not return in the process of the keeper. Returns its process in the guard.
pid_t start_keeper(Link& link);

/// True once the keeper, a child of this process, has ended or is stopped. Takes less than a microsecond.
bool is_lost(pid_t keeper) noexcept;

}  // namespace stepwire::guard
