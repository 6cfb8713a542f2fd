#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/base/fmi/calls.hpp"
#include "engine/base/fmi/foreign_call.hpp"
#include "engine/base/fmi/package.hpp"

namespace stepwire::fmi {

/// Operations of a running unit. After start, act and step it saves its state if `kept` has room.
enum class Operation : std::uint32_t {
  start,      ///< Creates an instance, sets its parameters and initializes it.
  outputs,    ///< Computes y at time, x, u.
  slopes,     ///< Computes dx at time, x, u.
  crossings,  ///< Computes z at time, x, u.
  act,        ///< Updates the discrete states at time, x, u; changes x where `changed` is set.
  step,       ///< Steps from time by length with u, then computes y.
  load,       ///< Restores the state saved in `kept`.
  quit
};

/// Sizes of the arrays of an exchange.
struct Counts {
  std::size_t inputs = 0, outputs = 0, states = 0, indicators = 0, kept = 0;

  std::size_t numbers() const { return inputs + outputs + 2 * states + indicators + kept; }
};

/// Data shared by a block and a running unit. It is one contiguous piece of memory, which two processes may
/// share. A step begins at `time`, may take `length`, and ends at `reached` [s].
struct Exchange {
  // Turn of the two processes: odd values are the unit's.
  std::atomic<std::uint32_t> turn{0};
  std::atomic<std::uint32_t> sleepers{0};
  CallNote call{};
  Operation operation = Operation::quit;
  std::uint32_t ok = 1, changed = 0;
  std::uint32_t ended = 0;  ///< 1: the unit ends the run at this instant; 2: it ended before this step
  double time = 0.0, length = 0.0, reached = 0.0;
  double next = 0.0;             ///< time of the next event [s]; infinity without one
  std::size_t state_bytes = 0;   ///< set by `start`: size of the unit's state; 0 if it cannot be serialised
  std::size_t kept_numbers = 0;  ///< the same in numbers, including the state of its events
  Counts counts;
  char message[400] = "";

  // The arrays follow this object in memory.
  double* inputs() { return reinterpret_cast<double*>(this + 1); }
  double* outputs() { return inputs() + counts.inputs; }
  double* states() { return outputs() + counts.outputs; }
  double* slopes() { return states() + counts.states; }
  double* indicators() { return slopes() + counts.states; }
  double* kept() { return indicators() + counts.indicators; }

  static std::size_t bytes(const Counts& counts) {
    return sizeof(Exchange) + counts.numbers() * sizeof(double);
  }
};

/// Transfers SI numbers to and from variables of a unit, grouped by type to one call each. Allocates only on
/// construction.
class ValueGroups {
 public:
  enum class Which { all, continuous };

  /// Numbers are in the order of the variables; those of an array are contiguous. With Which::continuous the
  /// other variables are skipped, but keep their positions.
  explicit ValueGroups(const std::vector<const Variable*>& variables, Which which = Which::all);

  std::size_t count() const { return count_; }
  bool get(Calls& calls, double* numbers);
  bool set(Calls& calls, const double* numbers);

 private:
  struct Place {
    std::size_t number;  ///< index among the SI numbers
    double factor, offset;
  };
  struct Group {
    Type type;
    std::vector<std::uint32_t> references;
    std::vector<Place> places;
    std::vector<double> room;  ///< buffer for values in the unit's type
  };

  std::vector<Group> groups_;
  std::size_t count_ = 0;
};

/// Start value of a variable [SI].
struct Assignment {
  const Variable* variable;
  std::vector<double> numbers;
};

/// Configuration of a running unit.
struct Setup {
  std::shared_ptr<const Package> package;
  Mode mode = Mode::co_simulation;
  std::string name;  ///< of the instance, for messages: the block's name
  std::vector<Assignment> assignments{};
};

/// Returns the numeric variables of a causality, in the order of the description.
std::vector<const Variable*> ports_of(const Description& description, Causality causality);

/// Returns the array sizes of an exchange with a unit, except for its saved state.
Counts counts_of(const Setup& setup);

/// One instance of a unit, which executes the operations of an exchange.
class Model {
 public:
  Model(const Setup& setup, Exchange& exchange);
  ~Model();

  /// Executes the operation of the exchange and sets `ok` and `message`. Does not throw.
  void run();

 private:
  /// Creates the instance; leave() frees it.
  void enter();
  void leave();
  bool perform();
  void start();
  bool assign();
  bool begin();
  bool iterate_events();
  /// Throw UnitError for invalid times and indicators.
  void require_next(const EventInfo& info) const;
  void require_reached(double reached);
  bool read_indicators();
  bool move_to(double time);
  bool act();
  bool end();
  bool step();
  bool save();
  bool load();
  void fail(const std::string& message);

  const Setup& setup_;
  Exchange& exchange_;
  std::unique_ptr<Calls> calls_;
  ValueGroups inputs_, continuous_inputs_, outputs_;
  std::vector<double> last_;  ///< values of discrete inputs at the last event
  std::vector<std::size_t> discrete_;
  double reached_ = 0.0;     ///< last successful time of the steps so far [s]
  std::vector<char> signs_;  ///< of the indicators after the last event
};

}  // namespace stepwire::fmi
