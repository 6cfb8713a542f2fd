#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "engine/base/fmi/foreign_call.hpp"
#include "engine/base/fmi/package.hpp"

namespace stepwire::fmi {

/// Tasks of a running unit. Behind start, act and step it saves its state, where that has room.
enum class Operation : std::uint32_t {
  start,      ///< makes an instance, sets its parameters, and initializes it
  outputs,    ///< y at time, x, u
  slopes,     ///< dx at time, x, u
  crossings,  ///< z at time, x, u
  act,        ///< its discrete part at time, x, u: changes x where `changed` is set
  step,       ///< from time by length with u, then y
  load,       ///< restores the state that it has saved into kept
  quit
};

/// How many numbers each stretch of an exchange has.
struct Counts {
  std::size_t inputs = 0, outputs = 0, states = 0, indicators = 0, kept = 0;

  std::size_t numbers() const { return inputs + outputs + 2 * states + indicators + kept; }
};

/// What a block and a running unit have in common: it lies in one piece of memory, which two processes may
/// share.
struct Exchange {
  // Between two processes: whose turn it is. Odd: the unit's.
  std::atomic<std::uint32_t> turn{0};
  std::atomic<std::uint32_t> sleepers{0};
  CallNote call{};
  Operation operation = Operation::quit;
  std::uint32_t ok = 1, changed = 0;
  std::uint32_t ended = 0;  ///< 1: the unit ends the run where it stands now; 2: it did so before this step
  double time = 0.0, length = 0.0;
  double next = 0.0;             ///< time of the next event [s], infinity where there is none
  std::size_t state_bytes = 0;   ///< after `start`: what the unit's state takes, 0 where it cannot be saved
  std::size_t kept_numbers = 0;  ///< the same in numbers, with what is remembered of events
  Counts counts;
  char message[400] = "";

  // The numbers lie behind.
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
