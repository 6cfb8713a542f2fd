#pragma once

#include <limits>

namespace stepwire {

/// Message that a block raises during a run, in update(), or in outputs() where these would become
/// non-finite. It is reported once, with the time at which it was raised first. A diagnostic declared with
/// `ends_run` ends the run at that tick: as a fault, or as `stop_when` does.
class Diagnostic {
 public:
  static constexpr double never = std::numeric_limits<double>::infinity();

  void raise(double time) {
    if (*first_ == never) *first_ = time;
  }
  bool raised() const { return *first_ != never; }
  void bind(double* first) { first_ = first; }

 private:
  double* first_ = nullptr;
};

}  // namespace stepwire
