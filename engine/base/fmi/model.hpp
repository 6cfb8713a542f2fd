#pragma once

#include <memory>
#include <vector>

#include "engine/base/fmi/calls.hpp"
#include "engine/base/fmi/exchange.hpp"
#include "engine/base/fmi/value_groups.hpp"

namespace stepwire::fmi {

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
