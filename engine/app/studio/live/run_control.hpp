#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/query/formula.hpp"
#include "engine/app/studio/live/command_queue.hpp"
#include "engine/app/studio/live/event_log.hpp"
#include "engine/app/studio/live/live_inputs.hpp"
#include "engine/app/studio/live/sample_store.hpp"
#include "engine/app/studio/live/signal_list.hpp"

namespace stepwire::live {

/// Buffer that collects the stored values of each tick, and passes rows to the store in batches. Not
/// thread-safe, except for the store.
class RowGathering {
 public:
  /// Accessor of a column's value in the workspace of a run.
  struct Column {
    std::size_t offset = 0;                           ///< in a workspace
    std::optional<expression::Expression> formula{};  ///< of the numbers at `places`
    std::vector<std::size_t> places{};

    double operator()(const double* values) const {
      return formula ? (*formula)(values, places) : values[offset];
    }
  };
  /// Column of the store whose samples start after tick 0.
  struct Incomplete {
    std::size_t index = 0;
    std::int64_t first_tick = 0;
    Column column;
  };

  /// Stores the recorded signals of the file. The signals must outlive it.
  RowGathering(const SignalList& signals, double step, const StoreOptions& options);

  /// Returns the column of a signal in the store; a new column starts at `next_tick`.
  std::size_t column(std::size_t signal, std::int64_t next_tick);
  /// Returns the column of a formula over signals; it starts at the first tick at which all of them are
  /// stored.
  std::size_t column(const query::Formula& formula, std::int64_t next_tick);
  /// Returns the offsets in the workspace that the columns read.
  std::vector<std::size_t> places() const;
  /// Appends the row of a tick from the workspace of a run.
  void take(const double* values);
  /// Passes all rows to the store. Throws EnvironmentError.
  void flush();
  /// Removes all rows from a tick on.
  void cut(std::int64_t tick);
  std::vector<Incomplete> incomplete() const;
  /// Inserts the samples of all ticks before the first one of a column.
  void put_past(std::size_t column, std::span<const double> samples) { store_.put_before(column, samples); }

  const SampleStore& store() const { return store_; }

 private:
  std::size_t add(std::size_t offset, std::int64_t tick);
  void fill(std::size_t column, std::int64_t from, std::int64_t to);

  const SignalList& signals_;
  SampleStore store_;
  std::vector<Column> columns_;
  std::map<std::size_t, std::size_t> of_offset_;  ///< columns by offset
  std::map<std::string, std::size_t> of_formula_;
  std::vector<double> rows_;  ///< rows that the store does not have yet
};

/// Schedule of ticks by the clock, at a rate that may change. Times are seconds of one clock.
class Pace {
 public:
  explicit Pace(double step) : step_(step) {}

  /// Returns simulated seconds per second of the clock; 0: as fast as possible.
  double rate() const { return rate_; }
  /// Sets the rate; `tick` is due now.
  void begin(double rate, std::int64_t tick, double now);
  /// Returns the due time of a tick; `now` for rate 0.
  double due(std::int64_t tick, double now) const {
    return rate_ > 0.0 ? start_ + static_cast<double>(tick - first_) * step_ / rate_ : now;
  }
  /// Records the begin of a tick. A tick that is more than 20 ms late counts as missed. Beyond 200 ms the
  /// schedule shifts instead of catching up.
  void begun(std::int64_t tick, double now);
  std::int64_t missed() const { return missed_; }
  /// Returns the rate measured over the last half second or more.
  double measured() const { return measured_; }

 private:
  double step_, rate_ = 1.0, start_ = 0.0, measured_ = 0.0;
  std::int64_t first_ = 0, missed_ = 0;
  double marked_ = 0.0;  ///< begin of the measurement
  std::int64_t marked_tick_ = 0;
};

/// State of a run.
struct RunStatus {
  enum class State { playing, paused, ended };
  State state = State::paused;
  std::uint32_t run = 0;    ///< increases with each restart and seek
  std::int64_t tick = 0;    ///< last computed tick
  double time = 0.0;        ///< its time [s]
  double rate = 0.0;        ///< recent simulated seconds per second of the clock
  double wanted = 1.0;      ///< requested rate; 0: as fast as possible
  std::int64_t missed = 0;  ///< ticks more than 20 ms late
  bool compiled = false;
  /// Page time of the newest input sample that has acted by a stored tick [s].
  std::optional<double> input;
  std::string fault;  ///< reason of a failure, else empty
};

/// Outcome of set().
struct SetResult {
  std::optional<double> value;  ///< SI; std::nullopt if it is no number
  std::string text;
  std::int64_t tick = 0;  ///< first tick with the new value
};

/// Run that pages control and observe, in threads of its own. Thread-safe; calls return after they have taken
/// effect. Values that are set are logged with their tick.
class RunControl {
 public:
  virtual ~RunControl() = default;

  /// Starts or continues the run. `rate`: simulated seconds per second of the clock; 0: as fast as possible.
  virtual void play(double rate) = 0;
  virtual void pause() = 0;
  /// Computes one tick and returns its number.
  virtual std::int64_t one_tick() = 0;
  /// Starts the run again with the present values.
  virtual void restart() = 0;
  /// Moves to a time as fast as possible, backwards from a checkpoint; returns the target tick.
  virtual std::int64_t seek(double time) = 0;
  /// Sets a value. Throws Error if the run refuses it.
  SetResult set(const std::string& name, const std::string& text);
  /// Queues a sample of an input. Throws Error for a wrong count of numbers. Returns at once.
  virtual void input(const InputSample& sample) { inputs_.push(sample); }
  /// Resets the inputs that this client wrote last to their defaults, from the next tick on.
  virtual void release(int client) { inputs_.release(client); }
  /// Records that a client is alive; any of its messages counts.
  virtual void heard(int) {}
  /// Returns the column of the store for a signal of the list, and starts storing it if needed.
  std::size_t stored(std::size_t signal) { return column_of(signal); }
  /// Returns the column of the store for a formula, and starts storing it if needed.
  std::size_t stored(const query::Formula& formula) { return column_of(formula); }

  RunStatus status() const;
  const SampleStore& store() const { return rows_.store(); }
  EventLog log();
  /// Returns the present value of a parameter in SI; std::nullopt if it is no number.
  std::optional<double> value(const std::string& parameter);
  /// Returns the timing of a real-time loop, as in the news `loop`; std::nullopt for a simulation.
  virtual std::optional<json::Json> timing() { return std::nullopt; }

 protected:
  /// `run`: number of the run. `changed` is called by the run's thread and must return soon. Plan and signals
  /// must outlive it.
  RunControl(const plan::Plan& plan, const SignalList& signals, const StoreOptions& store, std::uint32_t run,
             std::function<void()> changed);

  // Parts of the calls above that differ. The thread of the run executes them.
  virtual const run::Executor& executor() const = 0;
  /// Applies a value that is set; returns the first tick with it.
  virtual std::int64_t apply_now(const LiveEvent& event) = 0;
  virtual void take_rows() {}
  /// Follows a change of the stored columns.
  virtual void select() = 0;
  /// Writes state, input and fault, and the counts that differ.
  virtual void describe(RunStatus& status) const = 0;

  /// Publishes the status.
  void tell();
  /// Begins a log for a new start, with the values that are set now; calls `apply` for each of them.
  void begin_log(const std::function<void(const LiveEvent&)>& apply);
  std::int64_t next_tick() const { return shown_ + 1; }

  const plan::Plan& plan_;
  CommandQueue commands_;
  RowGathering rows_;
  LiveInputs inputs_;
  Pace pace_;
  EventLog log_;
  std::uint32_t lives_;              ///< number of the run
  std::int64_t shown_ = -1;          ///< last tick computed or received; -1: none
  mutable std::mutex status_mutex_;  ///< guards the status

 private:
  template <class Signal>
  std::size_t column_of(const Signal& signal) {
    return commands_.ask([&] {
      const std::size_t column = rows_.column(signal, next_tick());
      select();
      return column;
    });
  }

  RunStatus status_;
  std::function<void()> changed_;
};

}  // namespace stepwire::live
