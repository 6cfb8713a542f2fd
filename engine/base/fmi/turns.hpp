#pragma once

#include <atomic>
#include <cstdint>

namespace stepwire::fmi {

/// Hands the turn over: writes it, and wakes the other process where it sleeps.
void pass_turn(std::atomic<std::uint32_t>& turn, std::atomic<std::uint32_t>& sleepers, std::uint32_t to);

/// Waits until the turn is this one, first awake and then asleep; false where it is not within 20 ms.
bool await_turn(std::atomic<std::uint32_t>& turn, std::atomic<std::uint32_t>& sleepers, std::uint32_t own);

}  // namespace stepwire::fmi
