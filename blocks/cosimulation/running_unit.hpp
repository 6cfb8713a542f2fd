#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/base/fmi/runner.hpp"

namespace stepwire {

/// The instance of a unit that one block has in one run. A copy of a block has none until it starts.
class RunningUnit {
 public:
  RunningUnit() = default;
  RunningUnit(const RunningUnit& other)
      : setup_(other.setup_), isolated_(other.isolated_), kept_(other.kept_), sizes_(other.sizes_) {}
  RunningUnit& operator=(const RunningUnit&) = delete;

  /// Says what is run, and tries it: throws fmi::UnitError where it does not start.
  void prepare(fmi::Setup setup, bool isolated);
  /// How many numbers its state takes; 0 where it cannot be saved.
  std::size_t kept() const { return kept_; }
  /// Numbers of each input; how many outputs it has, and how many numbers they are; its event indicators.
  const std::vector<std::size_t>& input_sizes() const { return sizes_.inputs; }
  std::size_t output_count() const { return sizes_.outputs; }
  std::size_t numbers_shown() const { return sizes_.numbers_shown; }
  std::size_t indicator_count() const { return sizes_.indicators; }

  /// Makes the instance and initializes it; a fault is kept for message().
  void start(double time);
  /// Does nothing once something has failed.
  bool run(fmi::Operation operation);
  /// False once something has failed.
  bool works() const { return runner_ && works_; }
  void refuse(const char* message);
  std::string message() const;
  fmi::Exchange& exchange() const { return runner_->exchange(); }

  long moves = 1;                 ///< since the start, from 1: a guard that resets states writes 0
  std::vector<double> last_kept;  ///< its state after the last of them
  double acted_at = -1.0;         ///< time of its last event [s], and
  std::vector<double> acted_on;   ///< its inputs then

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
