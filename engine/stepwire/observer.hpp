#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include <stepwire/model.hpp>
#include <stepwire/snapshot.hpp>

#include "engine/simulate/run/flow.hpp"

namespace stepwire::plan {
struct SignalSlot;
}

namespace stepwire::run {
class Executor;
}

namespace stepwire {

using run::Flow;

/// Run of simulate() that an observer watches.
class Running {
 public:
  /// Internal view of the run, for the library itself.
  struct View {
    const Model::Content& model;
    run::Executor& run;
    const std::vector<plan::SignalSlot>& slots;
    std::size_t index;
  };
  explicit Running(const View& view) : view_(view) {}

  /// Returns the index among the runs of a sweep; 0 for a single run.
  std::size_t index() const { return view_.index; }
  std::int64_t tick() const;
  double time() const;  ///< [s]
  /// Returns the numbers of a signal, in SI. They are of this tick once it is evaluated, before that partly
  /// of the last one.
  std::span<const double> operator[](SignalId signal) const;

  // For before_tick() only; the effects are those of the functions of Simulation.
  void set(const std::string& name, double value);
  void set(const std::string& name, const std::string& text);
  void set(InputId input, double value);
  void set(InputId input, std::span<const double> values);
  void set(InputId input, std::initializer_list<double> values) {
    set(input, std::span(values.begin(), values.size()));
  }
  Snapshot snapshot() const;
  /// Loads a snapshot. Later rows are recorded again.
  void restore(const Snapshot& snapshot);

 private:
  View view_;
};

/// Observer of the runs of simulate() while they are computed. The runs of a sweep call it from several
/// threads concurrently. A run waits for each call.
class Observer {
 public:
  virtual ~Observer() = default;

  /// Called before the first tick.
  virtual void begin(const Running&) {}
  /// Called before each tick. Here an observer may write inputs, set values, and take or restore snapshots.
  virtual Flow before_tick(Running&) { return Flow::go_on; }
  /// Called after the outputs of a tick are computed.
  virtual void evaluated(const Running&) {}
  /// Called with a row of the entry `recording` of `record`: the time, then its signals.
  virtual void row(const Running&, std::size_t /*recording*/, std::span<const double> /*numbers*/) {}
  /// Called after the last tick, after any kind of end.
  virtual void end(const Running&) {}
};

}  // namespace stepwire
