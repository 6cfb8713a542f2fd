#pragma once

#include <memory>

#include "engine/base/fmi/model.hpp"

namespace stepwire::fmi {

/// A running unit, in this process or in one of its own.
class Runner {
 public:
  virtual ~Runner() = default;

  Exchange& exchange() { return *exchange_; }
  /// Does an operation with the numbers of the exchange; false where it fails, and the exchange has why.
  /// Allocates nothing.
  virtual bool run(Operation operation) = 0;

 protected:
  Exchange* exchange_ = nullptr;
};

/// `kept` is how many numbers its state takes. A unit that is isolated runs in a process of its own: what
/// ends that one is a failure of the operation, and it ends with this one. A call of another unit that exits
/// or hangs ends this process with a sentence (CallWatch). Throws UnitError where the system gives no
/// process.
std::unique_ptr<Runner> make_runner(const Setup& setup, bool isolated, std::size_t kept = 0);

}  // namespace stepwire::fmi
