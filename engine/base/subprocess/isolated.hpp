#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <stdexcept>

#include "engine/base/io/descriptor.hpp"

namespace stepwire::subprocess {

/// Limits of a function in a process of its own.
struct IsolationBounds {
  std::chrono::milliseconds limit;  ///< time after which it is killed
  std::size_t memory;               ///< [bytes] beyond the memory of this process
};

/// Thrown where an isolated function has no result. The text is one sentence that begins with a verb: "was
/// ended by signal 11 (Segmentation fault)".
class IsolationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs a function in a process of its own, as a protection against foreign code that corrupts memory. Its
/// prints are discarded. It writes its result to `output`, a file in memory that this function returns,
/// rewound. The function inherits the locks of the calling thread and must not wait for other threads: none
/// exist. Throws IsolationError where it crashes, throws or exceeds its limits, and ProcessStopped on an
/// interruption.
io::Descriptor call_isolated(const std::function<void(int output)>& function, const IsolationBounds& bounds);

}  // namespace stepwire::subprocess
