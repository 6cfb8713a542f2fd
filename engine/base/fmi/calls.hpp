#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "engine/base/fmi/foreign_call.hpp"
#include "engine/base/fmi/package.hpp"

namespace stepwire::fmi {

/// Which interface of a unit is used.
enum class Mode { co_simulation, model_exchange };

/// What a unit says after its discrete part has been updated.
struct EventInfo {
  bool again = false, terminates = false, states_changed = false;
  bool has_next = false;
  double next = 0.0;  ///< time of its next event [s]
};

/// What a unit says of a step that it has made.
struct StepInfo {
  bool terminates = false, enters_event = false;
  bool made = true;      ///< false where the unit has ended before it
  double reached = 0.0;  ///< time that the unit has reached [s]; FMI 2 has no such number of its own
};

/// The calls of one instance, alike for both versions. A call that fails is false, and message() says why.
class Calls {
 public:
  virtual ~Calls() = default;

  virtual bool set_up(double start) = 0;  ///< enters initialization mode
  virtual bool initialize() = 0;          ///< leaves it
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

  /// Bytes of its state; 0 where it cannot be had.
  virtual std::size_t state_size() = 0;
  virtual bool save(char* bytes, std::size_t count) = 0;
  virtual bool load(const char* bytes, std::size_t count) = 0;

  /// What the unit has logged last of a fault, or the name of the call that failed.
  virtual std::string message() const = 0;
};

/// Loads the binary, and makes an instance, whose calls are noted. Throws UnitError.
std::unique_ptr<Calls> instantiate(const Package& package, Mode mode, const std::string& name,
                                   CallNote& note);

/// The interface of a mode.
const Interface& interface_of(const Description& description, Mode mode);

}  // namespace stepwire::fmi
