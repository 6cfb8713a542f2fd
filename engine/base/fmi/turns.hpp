#pragma once

#include <atomic>
#include <cstdint>

namespace stepwire::fmi {

/// Passes the turn to the other process and wakes it if it sleeps.
void pass_turn(std::atomic<std::uint32_t>& turn, std::atomic<std::uint32_t>& sleepers, std::uint32_t to);

/// Waits for this turn, first by polling, then asleep. Returns false after 20 ms.
bool await_turn(std::atomic<std::uint32_t>& turn, std::atomic<std::uint32_t>& sleepers, std::uint32_t own);

}  // namespace stepwire::fmi
