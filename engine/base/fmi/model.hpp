#pragma once

#include <memory>
#include <vector>

#include "engine/base/fmi/calls.hpp"
#include "engine/base/fmi/exchange.hpp"
#include "engine/base/fmi/value_groups.hpp"

namespace stepwire::fmi {

/// A value that a variable has before the start [SI].
struct Assignment {
  const Variable* variable;
  std::vector<double> numbers;
};

/// How a unit is run.
struct Setup {
  std::shared_ptr<const Package> package;
  Mode mode = Mode::co_simulation;
  std::string name;  ///< of the instance, for messages: that of the block
  std::vector<Assignment> assignments{};
};

/// The variables of a causality that are numbers, in the order of the description.
std::vector<const Variable*> ports_of(const Description& description, Causality causality);

/// The numbers of an exchange with a unit, but for what it keeps.
Counts counts_of(const Setup& setup);

/// One instance of a unit, which does what an exchange says.
class Model {
 public:
  Model(const Setup& setup, Exchange& exchange);
  ~Model();

  /// Does the operation that the exchange names; `ok` and `message` say how it went. Throws nothing.
  void run();

 private:
  /// Makes the instance, and frees it.
  void enter();
  void leave();
  bool perform();
  void start();
  bool assign();
  bool begin();
  bool iterate_events();
  /// Throw UnitError for times and indicators that no unit may have.
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
  std::vector<double> last_;  ///< numbers of discrete inputs at the last event
  std::vector<std::size_t> discrete_;
  double reached_ = 0.0;     ///< last successful time of the steps up to now [s]
  std::vector<char> signs_;  ///< of the indicators, after the last event
};

}  // namespace stepwire::fmi
