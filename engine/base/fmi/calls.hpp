#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "engine/base/fmi/foreign_call.hpp"
#include "engine/base/fmi/package.hpp"

namespace stepwire::fmi {

/// FMI interface through which a unit is run.
enum class Mode { co_simulation, model_exchange };

/// Result of an update of discrete states.
struct EventInfo {
  bool again = false, terminates = false, states_changed = false;
  bool has_next = false;
  double next = 0.0;  ///< time of its next event [s]
};

/// Result of a co-simulation step.
struct StepInfo {
  bool terminates = false, enters_event = false;
  bool made = true;      ///< false where the unit terminated before the step
  double reached = 0.0;  ///< last successful time [s]; FMI 2 returns it only for discarded steps
};

/// Calls of one instance, common to both versions. They return false on failure; message() then has the
/// reason.
class Calls {
 public:
  virtual ~Calls() = default;

  virtual bool set_up(double start) = 0;  ///< enters initialization mode
  virtual bool initialize() = 0;          ///< leaves initialization mode
  virtual bool get(Type type, const std::uint32_t* references, std::size_t count, void* values,
                   std::size_t numbers) = 0;
  virtual bool set(Type type, const std::uint32_t* references, std::size_t count, const void* values,
                   std::size_t numbers) = 0;

  virtual bool set_time(double time) = 0;
  virtual bool set_states(const double* states, std::size_t count) = 0;
  virtual bool get_states(double* states, std::size_t count) = 0;
  virtual bool get_slopes(double* slopes, std::size_t count) = 0;
  virtual bool get_indicators(double* indicators, std::size_t count) = 0;
  virtual bool complete_step(StepInfo& info) = 0;
  virtual bool enter_event() = 0;
  virtual bool update(EventInfo& info) = 0;
  virtual bool leave_event() = 0;

  virtual bool step(double time, double length, StepInfo& info) = 0;

  /// Returns the size of its serialised state [bytes]; 0 where the unit cannot serialise it.
  virtual std::size_t state_size() = 0;
  virtual bool save(char* bytes, std::size_t count) = 0;
  virtual bool load(const char* bytes, std::size_t count) = 0;

  /// Returns the last fault that the unit has logged, or the name of the failed call.
  virtual std::string message() const = 0;
};

/// Loads the binary and creates an instance; `note` records its calls. Throws UnitError.
std::unique_ptr<Calls> instantiate(const Package& package, Mode mode, const std::string& name,
                                   CallNote& note);

/// Returns the interface of a mode.
const Interface& interface_of(const Description& description, Mode mode);

}  // namespace stepwire::fmi
