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

/// A run of simulate() as an observer sees it.
class Running {
 public:
  /// What it looks at; for the library itself.
  struct View {
    const Model::Content& model;
    run::Executor& run;
    const std::vector<plan::SignalSlot>& slots;
    std::size_t index;
  };
  explicit Running(const View& view) : view_(view) {}

  /// Among the runs of a sweep; 0 for a single one.
  std::size_t index() const { return view_.index; }
  std::int64_t tick() const;
  double time() const;  ///< [s]
  /// The numbers of a signal, in SI: of this tick once it is evaluated, until then what there is of it.
  std::span<const double> operator[](SignalId signal) const;

  // In before_tick() alone; each as Simulation does it.
  void set(const std::string& name, double value);
  void set(const std::string& name, const std::string& text);
  void set(InputId input, double value);
  void set(InputId input, std::span<const double> values);
  void set(InputId input, std::initializer_list<double> values) {
    set(input, std::span(values.begin(), values.size()));
  }
  Snapshot snapshot() const;
  /// What was recorded from that moment on is recorded anew.
  void restore(const Snapshot& snapshot);

 private:
  View view_;
};

/// Watches the runs of simulate() while they are computed. The runs of a sweep call from several threads at a
/// time. A run waits for each call.
class Observer {
 public:
  virtual ~Observer() = default;

  /// Before the first tick.
  virtual void begin(const Running&) {}
  /// Before each tick: here inputs are written, values set, moments kept and restored.
  virtual Flow before_tick(Running&) { return Flow::go_on; }
  /// After the outputs of a tick are computed.
  virtual void evaluated(const Running&) {}
  /// A row that the entry `recording` of `record` keeps: the time, then its signals.
  virtual void row(const Running&, std::size_t /*recording*/, std::span<const double> /*numbers*/) {}
  /// After the last tick, whatever ended the run.
  virtual void end(const Running&) {}
};

}  // namespace stepwire
