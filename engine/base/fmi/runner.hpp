#pragma once

#include <memory>

#include "engine/base/fmi/model.hpp"

namespace stepwire::fmi {

/// A running unit, in this process or in one of its own.
class Runner {
 public:
  virtual ~Runner() = default;

  Exchange& exchange() { return *exchange_; }
  /// Executes an operation on the exchange. Returns false on failure; the exchange then has the message. Does
  /// not allocate.
  virtual bool run(Operation operation) = 0;

 protected:
  Exchange* exchange_ = nullptr;
};

/// Starts a unit; `kept` is the number of doubles reserved for its saved state. An isolated unit runs in a
/// process of its own, which ends with this one; a crash of it fails the operation. A call of another unit
/// that exits or hangs ends this process with a message (CallWatch). Throws UnitError where no process can be
/// created.
std::unique_ptr<Runner> make_runner(const Setup& setup, bool isolated, std::size_t kept = 0);

}  // namespace stepwire::fmi
