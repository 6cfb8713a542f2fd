#pragma once

#include <atomic>
#include <functional>

#include "engine/app/python/raised.hpp"

namespace stepwire::python {

/// Does work in a thread of its own and without the interpreter lock, while this thread, which holds it,
/// waits and looks at signals: an exception of their handlers (KeyboardInterrupt) is kept and sets the flag
/// that the work looks at. Throws what the work throws.
void call_watched(const std::function<void(std::atomic<bool>& interrupt)>& work, Raised& raised);

}  // namespace stepwire::python
