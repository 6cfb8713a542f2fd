#pragma once

#include <memory>

#include "engine/app/python/raised.hpp"
#include "engine/stepwire/model.hpp"
#include "engine/stepwire/observer.hpp"

namespace stepwire::python {

/// Shows a run to an object of Python's: to its methods `begin`, `before_tick`, `evaluated`, `row` and `end`,
/// as far as it has them, or to the object itself where it can be called, as `evaluated`. What it sets holds
/// from the next tick on. A run ends as soon as one of them raises something.
class PythonObserver : public Observer {
 public:
  /// The lock is held. Throws TypeError of Python's for an object that cannot be called.
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

/// Adds the class `Running`.
void add_observing(_object* module);

}  // namespace stepwire::python
