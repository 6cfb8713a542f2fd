#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "engine/base/fmi/foreign_call.hpp"
#include "engine/base/fmi/package.hpp"

namespace stepwire::fmi {

/// Operations of a running unit. After start, act and step it saves its state if `kept` has room.
enum class Operation : std::uint32_t {
  start,      ///< Creates an instance, sets its parameters and initializes it.
  outputs,    ///< Computes y at time, x, u.
  slopes,     ///< Computes dx at time, x, u.
  crossings,  ///< Computes z at time, x, u.
  act,        ///< Updates the discrete states at time, x, u; changes x where `changed` is set.
  step,       ///< Steps from time by length with u, then computes y.
  load,       ///< Restores the state saved in `kept`.
  quit
};

/// Sizes of the arrays of an exchange.
struct Counts {
  std::size_t inputs = 0, outputs = 0, states = 0, indicators = 0, kept = 0;

  std::size_t numbers() const { return inputs + outputs + 2 * states + indicators + kept; }
};

/// Data shared by a block and a running unit. It is one contiguous piece of memory, which two processes may
/// share. A step begins at `time`, may take `length`, and ends at `reached` [s].
struct Exchange {
  // Turn of the two processes: odd values are the unit's.
  std::atomic<std::uint32_t> turn{0};
  std::atomic<std::uint32_t> sleepers{0};
  CallNote call{};
  Operation operation = Operation::quit;
  std::uint32_t ok = 1, changed = 0;
  std::uint32_t ended = 0;  ///< 1: the unit ends the run at this instant; 2: it ended before this step
  double time = 0.0, length = 0.0, reached = 0.0;
  double next = 0.0;             ///< time of the next event [s]; infinity without one
  std::size_t state_bytes = 0;   ///< set by `start`: size of the unit's state; 0 if it cannot be serialised
  std::size_t kept_numbers = 0;  ///< the same in numbers, including the state of its events
  Counts counts;
  char message[400] = "";

  // The arrays follow this object in memory.
  double* inputs() { return reinterpret_cast<double*>(this + 1); }
  double* outputs() { return inputs() + counts.inputs; }
  double* states() { return outputs() + counts.outputs; }
  double* slopes() { return states() + counts.states; }
  double* indicators() { return slopes() + counts.states; }
  double* kept() { return indicators() + counts.indicators; }

  static std::size_t bytes(const Counts& counts) {
    return sizeof(Exchange) + counts.numbers() * sizeof(double);
  }
};

}  // namespace stepwire::fmi
