#pragma once

// Part of the sources of every exported unit: the standard library alone is included.

#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdio>

namespace stepwire::fmu {

/// What a variable of a unit is.
enum class Kind { time, parameter, input, output, state, slope, indicator };

/// A variable of a unit; its value reference is its place in the table.
struct UnitVariable {
  Kind kind;
  int size;                         ///< numbers
  int rows;                         ///< of a matrix whose numbers lie column by column; else 1
  double* (*place)(void* diagram);  ///< of the first number; null for the time
  const char* name;
};

/// Both versions of FMI have these numbers.
enum class Status { ok = 0, warning = 1, discard = 2, error = 3 };

/// Where a unit stands, by which the calls follow that it may have.
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

/// What became of a step.
struct StepEnd {
  bool terminates = false;
  bool whole = true;  ///< was the step made to its end?
  double last = 0.0;  ///< time that was reached [s]
};

/// References of variables, as a call has them.
struct References {
  const std::uint32_t* of;
  std::size_t count;
};

/// One instance of a unit, for the functions of both versions of FMI. Each call says what is wrong in a
/// message.
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
  virtual Status derivative(References unknowns, References knowns, const double* seed,
                            double* sensitivity) = 0;
  /// Numbers of these variables together; -1 where one is none.
  virtual std::ptrdiff_t numbers_of(References references) const = 0;

  virtual Status step(double time, double length, StepEnd& end) = 0;

  virtual Status set_time(double time) = 0;
  virtual Status set_states(const double* states, std::size_t count) = 0;
  virtual Status get_states(double* states, std::size_t count) = 0;
  virtual Status get_slopes(double* slopes, std::size_t count) = 0;
  virtual Status get_crossings(double* numbers, std::size_t count) = 0;
  virtual Status complete_step(bool& terminates) = 0;
  virtual Status enter_event() = 0;
  /// `next` becomes the time of the next event that is known beforehand, infinite where there is none [s].
  virtual Status update(bool& terminates, double& next) = 0;
  virtual Status leave_event() = 0;

  virtual std::size_t state_bytes() const = 0;
  virtual void save(void* bytes) const = 0;
  /// Are these bytes a state of this unit?
  virtual Status check_state(const void* bytes, std::size_t count) = 0;
  virtual Status load(const void* bytes) = 0;

  /// Logs a message, and is an error.
  [[gnu::format(printf, 2, 3)]] Status refuse(const char* format, ...) {
    char message[400];
    va_list values;
    va_start(values, format);
    std::vsnprintf(message, sizeof message, format, values);
    va_end(values);
    log_(caller_, Status::error, message);
    return Status::error;
  }

  /// Is a call one of these phases? If not, that is logged.
  bool allows(unsigned phases, const char* call) {
    if ((static_cast<unsigned>(phase()) & phases) != 0) return true;
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

/// What the generated source of a unit defines.
struct UnitSource {
  const char* token;
  const char* no_exchange;  ///< why there is no model exchange; null where there is
  ExportedUnit* (*make)(bool exchange, void* caller, ExportedUnit::Log log);  ///< null without memory
};
extern const UnitSource unit_source;

}  // namespace stepwire::fmu
