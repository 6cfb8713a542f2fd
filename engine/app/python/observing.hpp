#pragma once

#include <memory>

#include "engine/app/python/raised.hpp"
#include "engine/stepwire/model.hpp"
#include "engine/stepwire/observer.hpp"

namespace stepwire::python {

/// Observer that calls a Python object: its methods `begin`, `before_tick`, `evaluated`, `row` and `end`,
/// where they exist. A callable without them is called as `evaluated`.
/// Inputs that it sets apply from the next tick on. A run ends after an exception in one of these calls.
class PythonObserver : public Observer {
 public:
  /// The caller must hold the interpreter lock. Throws Python's TypeError for an object without these methods
  /// that is not callable.
  PythonObserver(_object* object, Model model, Raised& raised);
  ~PythonObserver() override;

  void begin(const Running& run) override;
  Flow before_tick(Running& run) override;
  void evaluated(const Running& run) override;
  void row(const Running& run, std::size_t recording, std::span<const double> numbers) override;
  void end(const Running& run) override;

 private:
  struct Shown;
  void call(const Held& method, const Running& run);
  Shown& shown_of(const Running& run);
  bool set_waiting(Shown& shown, Running& run);

  struct State;
  Model model_;
  Raised& raised_;
  std::unique_ptr<State> state_;
};

void add_observing(_object* module);

}  // namespace stepwire::python
