#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/base/fmi/runner.hpp"

namespace stepwire {

/// Instance of an FMU of one block in one run. A copy of a block has no instance until it starts.
class RunningUnit {
 public:
  RunningUnit() = default;
  RunningUnit(const RunningUnit& other)
      : setup_(other.setup_), isolated_(other.isolated_), kept_(other.kept_), sizes_(other.sizes_) {}
  RunningUnit& operator=(const RunningUnit&) = delete;

  /// Sets the unit and tries it. Throws fmi::UnitError if it does not start.
  void prepare(fmi::Setup setup, bool isolated);
  /// Returns the count of numbers in its state; 0 if it cannot be saved.
  std::size_t kept() const { return kept_; }
  /// Return the sizes of the inputs, the counts of outputs and of their numbers, and the count of event
  /// indicators.
  const std::vector<std::size_t>& input_sizes() const { return sizes_.inputs; }
  std::size_t output_count() const { return sizes_.outputs; }
  std::size_t numbers_shown() const { return sizes_.numbers_shown; }
  std::size_t indicator_count() const { return sizes_.indicators; }

  /// Creates and initialises the instance; a fault is stored for message().
  void start(double time);
  /// Runs an operation; no effect after a failure.
  bool run(fmi::Operation operation);
  /// False after a failure.
  bool works() const { return runner_ && works_; }
  void refuse(const char* message);
  std::string message() const;
  fmi::Exchange& exchange() const { return runner_->exchange(); }

  long moves = 1;                 ///< changes since the start, from 1; a guard that resets states writes 0
  std::vector<double> last_kept;  ///< state after the last change
  double acted_at = -1.0;         ///< time of its last event [s]
  std::vector<double> acted_on;   ///< inputs at that event
  /// States after an event of time that was handled before the outputs of a tick, and that no update has
  /// stored; `early_at` is its time [s], below 0 without one.
  std::vector<double> early_states;
  double early_at = -1.0;

 private:
  fmi::Setup setup_;
  struct Sizes {
    std::vector<std::size_t> inputs{};
    std::size_t outputs = 0, numbers_shown = 0, indicators = 0;
  };
  bool isolated_ = true;
  std::size_t kept_ = 0;
  Sizes sizes_{};
  std::unique_ptr<fmi::Runner> runner_;
  bool works_ = true;
  const char* refused_ = nullptr;
  std::string not_started_;
};

}  // namespace stepwire
