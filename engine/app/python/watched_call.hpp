#pragma once

#include <atomic>
#include <functional>

#include "engine/app/python/raised.hpp"

namespace stepwire::python {

/// Runs `work` on another thread without the interpreter lock. Meanwhile this thread, which must hold the
/// lock, checks Python signals.
/// An exception of a signal handler (KeyboardInterrupt) is stored in `raised`, and sets the flag that `work`
/// polls. Rethrows exceptions of `work`.
void call_watched(const std::function<void(std::atomic<bool>& interrupt)>& work, Raised& raised);

/// The same, but throws such an exception.
void call_checked(const std::function<void()>& work);

}  // namespace stepwire::python
