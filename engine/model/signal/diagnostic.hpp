#pragma once

#include <limits>

namespace stepwire {

/// Something a block has to say during a run: raised in update(), or in outputs() where these would be
/// numbers that are not finite; told once, with the time at which it happened first. A diagnostic declared
/// with `ends_run` ends the run at that tick: as a fault, or as `stop_when` does.
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
