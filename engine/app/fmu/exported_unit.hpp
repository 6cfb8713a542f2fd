#pragma once

// Part of the sources of every exported unit, so it includes only the standard library.

#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <initializer_list>

namespace stepwire::fmu {

/// Role of a variable in a unit.
enum class Kind { time, parameter, input, output, state, slope, indicator };

/// Variable of a unit. Its value reference is its index in the table.
struct UnitVariable {
  Kind kind;
  int size;                         ///< count of numbers
  int rows;                         ///< rows of a matrix in column-major order; else 1
  double* (*place)(void* diagram);  ///< address of the first number; nullptr for the time
  const char* name;
};

/// Status of a call, with the numbers of both FMI versions.
enum class Status { ok = 0, warning = 1, discard = 2, error = 3 };

/// State of the FMI state machine; it determines which calls are legal. The values are bits, so that a set of
/// states is their sum.
enum class Phase : unsigned {
  made = 1,
  initializing = 2,
  at_event = 4,
  continuous = 8,
  stepping = 16,
  ended = 32,
  failed = 64
};

constexpr unsigned operator|(Phase a, Phase b) {
  return static_cast<unsigned>(a) | static_cast<unsigned>(b);
}
constexpr unsigned operator|(unsigned a, Phase b) {
  return a | static_cast<unsigned>(b);
}

/// Outcome of a step.
struct StepEnd {
  bool terminates = false;
  bool whole = true;  ///< false after a step that ended early
  double last = 0.0;  ///< time at the end of the step [s]
};

/// Value references in a call.
struct References {
  const std::uint32_t* of;
  std::size_t count;
};

/// Argument of a call that points to `count` values.
struct Argument {
  const char* name;  ///< its name in the standard
  const void* values;
  std::size_t count = 1;
};

/// Instance of a unit, shared by the functions of both FMI versions. Each failed call logs a message.
class ExportedUnit {
 public:
  using Log = void (*)(void* caller, Status status, const char* message);

  ExportedUnit(void* caller, Log log) : caller_(caller), log_(log) {}
  virtual ~ExportedUnit() = default;
  ExportedUnit(const ExportedUnit&) = delete;

  virtual Phase phase() const = 0;
  virtual bool exchanges() const = 0;
  virtual std::size_t state_count() const = 0;
  virtual std::size_t crossing_count() const = 0;

  virtual Status enter_initialization(double start) = 0;
  virtual Status leave_initialization() = 0;
  virtual Status terminate() = 0;
  virtual Status reset() = 0;
  virtual Status get(References references, double* values, std::size_t numbers) = 0;
  virtual Status set(References references, const double* values, std::size_t numbers) = 0;
  virtual Status derivative(References unknowns, References knowns, const double* seed, std::size_t seeds,
                            double* sensitivity, std::size_t sensitivities) = 0;

  virtual Status step(double time, double length, StepEnd& end) = 0;

  virtual Status set_time(double time) = 0;
  virtual Status set_states(const double* states, std::size_t count) = 0;
  virtual Status get_states(double* states, std::size_t count) = 0;
  virtual Status get_nominals(double* nominals, std::size_t count) = 0;
  virtual Status get_slopes(double* slopes, std::size_t count) = 0;
  virtual Status get_crossings(double* numbers, std::size_t count) = 0;
  virtual Status complete_step(bool& terminates) = 0;
  virtual Status enter_event() = 0;
  /// Sets `next` to the time of the next time event [s]; infinity if there is none.
  virtual Status update(bool& terminates, double& next) = 0;
  virtual Status leave_event() = 0;

  virtual std::size_t state_bytes() const = 0;
  virtual void save(void* bytes) const = 0;
  /// Fails if the bytes are not a saved state of this unit.
  virtual Status check_state(const void* bytes, std::size_t count) = 0;
  virtual Status load(const void* bytes) = 0;

  /// Logs a message and returns Status::error.
  [[gnu::format(printf, 2, 3)]] Status refuse(const char* format, ...) {
    char message[400];
    va_list values;
    va_start(values, format);
    std::vsnprintf(message, sizeof message, format, values);
    va_end(values);
    log_(caller_, Status::error, message);
    return Status::error;
  }

  /// True if no argument is a null pointer; else logs the first that is.
  bool given(const char* call, std::initializer_list<Argument> arguments) {
    for (const Argument& argument : arguments)
      if (argument.count > 0 && !argument.values) {
        refuse("%s: %s is a null pointer; it has to point to %zu value%s", call, argument.name,
               argument.count, argument.count == 1 ? "" : "s");
        return false;
      }
    return true;
  }

  /// True if the present phase is in `phases` and no argument is a null pointer; else logs the reason.
  bool allows(unsigned phases, const char* call, std::initializer_list<Argument> arguments = {}) {
    if ((static_cast<unsigned>(phase()) & phases) != 0) return given(call, arguments);
    refuse("%s is no call for a unit that %s", call, phase_words());
    return false;
  }

 private:
  const char* phase_words() const {
    switch (phase()) {
      case Phase::made:
        return "is not initialized yet";
      case Phase::initializing:
        return "is being initialized";
      case Phase::at_event:
        return "stands in event mode";
      case Phase::continuous:
        return "stands in continuous-time mode";
      case Phase::stepping:
        return "stands in step mode";
      case Phase::ended:
        return "is terminated";
      default:
        return "has failed";
    }
  }

  void* caller_;
  Log log_;
};

/// Definitions in the generated source of a unit.
struct UnitSource {
  const char* token;
  const char* no_exchange;  ///< reason why model exchange is not possible; nullptr if it is
  ExportedUnit* (*make)(bool exchange, void* caller, ExportedUnit::Log log);  ///< nullptr if out of memory
};
extern const UnitSource unit_source;

}  // namespace stepwire::fmu
