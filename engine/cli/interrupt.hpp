#pragma once

#include <atomic>

namespace stepwire {

/// Set by the first Ctrl-C (or SIGTERM) after catch_interrupts(); the second one ends the program at once.
const std::atomic<bool>& interrupted();
void catch_interrupts();

}  // namespace stepwire
