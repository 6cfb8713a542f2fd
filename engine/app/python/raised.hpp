#pragma once

#include <atomic>

#include "engine/app/python/lock.hpp"

namespace stepwire::python {

/// Exceptions of Python callables and blocks during a run. The first one is raised again by the call that
/// made the run. Callers must hold the interpreter lock.
class Raised {
 public:
  /// Stores the current exception of the interpreter.
  void keep();
  bool any() const { return any_; }
  /// Returns the latest stored exception; the object owns it.
  _object* latest() const { return latest_.get(); }
  /// Returns the first exception with its traceback and clears the store; nullptr if there is none.
  Held take();
  /// Raises the first exception again in the interpreter and throws, if there is one.
  void throw_if_any();

 private:
  std::atomic<bool> any_ = false;
  Held exception_, latest_;
};

}  // namespace stepwire::python
