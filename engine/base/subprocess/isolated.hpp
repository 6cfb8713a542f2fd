#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <stdexcept>

#include "engine/base/io/descriptor.hpp"

namespace stepwire::subprocess {

/// What bounds a function in a process of its own.
struct IsolationBounds {
  std::chrono::milliseconds limit;  ///< after which it is ended
  std::size_t memory;               ///< [bytes] that it may take beyond those of this process
};

/// Why there is no result of a function in a process of its own, in one sentence that begins with a verb:
/// "was ended by signal 11 (Segmentation fault)".
class IsolationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Calls a function in a process of its own, for what foreign code may do to memory. It prints nothing, and
/// all that comes back is what it writes to `output`: a file in memory, which this returns from its
/// beginning. The function holds the locks that this thread holds, and waits for no other thread: there is
/// none. Throws IsolationError where it crashes, throws, or passes its bounds, ProcessStopped where an
/// interruption ends it.
io::Descriptor call_isolated(const std::function<void(int output)>& function, const IsolationBounds& bounds);

}  // namespace stepwire::subprocess
