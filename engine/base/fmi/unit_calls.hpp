#pragma once

#include "engine/base/fmi/calls.hpp"
#include "engine/base/fmi/foreign_call.hpp"
#include "engine/base/fmi/log_text.hpp"

namespace stepwire::fmi {

/// Base of the calls of both versions; all calls into a unit are made here.
class UnitCalls : public Calls {
 public:
  std::string message() const override { return log_.empty() ? fault_.text() : log_.text(); }

 protected:
  explicit UnitCalls(CallNote& note) : note_(note) {}

  template <class Function, class... Arguments>
  auto call(const char* name, Function* function, Arguments... arguments) {
    const ForeignCall call(note_, name);
    return function(arguments...);
  }
  /// Calls a function that returns a status. Returns false for a fault and for an undefined status.
  template <class Function, class... Arguments>
  bool done(const char* name, Function* function, Arguments... arguments) {
    return accept(name, static_cast<int>(call(name, function, arguments...)));
  }
  /// Records a status; false for a fault. Discard and higher statuses are faults.
  bool accept(const char* name, int status);
  bool failed() const { return failed_; }

  CallNote& note_;
  LogText log_;

 private:
  LogText fault_;
  bool failed_ = false;
};

/// True for the fault statuses and for numbers that the standard does not define.
constexpr bool is_fault(int status) {
  return status < 0 || status >= 2;
}

}  // namespace stepwire::fmi
