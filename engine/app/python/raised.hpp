#pragma once

#include <atomic>

#include "engine/app/python/lock.hpp"

namespace stepwire::python {

/// The first exception that a callable or a block of Python's raised while a run went on, to be raised again
/// by the call that ran it. From any thread that holds the interpreter lock.
class Raised {
 public:
  /// Takes the exception that is set now.
  void keep();
  bool any() const { return any_; }
  /// The exception that was kept last; the object holds it.
  _object* latest() const { return latest_.get(); }
  /// The first exception, with its traceback; null where there is none. There is none
  /// afterwards.
  Held take();
  /// Sets it in the interpreter and throws, where there is one.
  void throw_if_any();

 private:
  std::atomic<bool> any_ = false;
  Held exception_, latest_;
};

}  // namespace stepwire::python
