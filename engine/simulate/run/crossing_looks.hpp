#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "engine/simulate/run/bound_blocks.hpp"
#include "engine/simulate/run/stop_condition.hpp"

namespace stepwire::run {

/// Zero-crossing functions of a run, and the edges that sources declare.
class CrossingLooks {
 public:
  explicit CrossingLooks(BoundBlocks& blocks);

  void find(double* numbers) const {
    if (guarded_ || stop_margin_) return find_all(numbers);
    for (const Look& look : looks_) look.run(look.block, numbers + look.first);
  }
  /// True if functions may have changed although time and states have not.
  bool may_change() const { return stop_changes_ || !changing_.empty(); }
  /// Evaluates these only.
  void find_changing(double* numbers) const {
    if (!changing_.empty()) find(changing_, numbers);
    if (stop_changes_) numbers[*plan_.stop_crossing] = (*stop_margin_)(values_);
  }
  /// Returns the time of the next jump or kink of a source, or of the end of the run by a block [s]; infinity
  /// without one.
  double next_edge() const {
    return edges_.empty() && ends_.empty() ? std::numeric_limits<double>::infinity() : earliest_edge();
  }
  /// True once a located `stop_when` holds or a block has ended the run, or does so now with a fault.
  bool stops() const;
  bool may_stop() const { return may_stop_; }

 private:
  /// Crossing functions of one block.
  struct Look {
    void (*run)(const void* block, double* numbers);
    const void* block;
    const double* active;  ///< address of the guard's number; 0.0 while the functions are off
    std::size_t first, count;
  };
  struct Edge {
    double (*next)(const void* block);
    const void* block;
  };

  void add(const plan::CrossingCall& call, const std::vector<bool>& settled);
  void add_stop(const std::vector<bool>& settled);
  void find_all(double* numbers) const;
  static void find(const std::vector<Look>& looks, double* numbers);
  double earliest_edge() const;

  const plan::Plan& plan_;
  const BoundBlocks& blocks_;
  const double* const values_;
  std::vector<Look> looks_, changing_;
  bool guarded_ = false;  ///< true if a guard may turn functions off
  std::vector<Edge> edges_;
  std::optional<StopMargin> stop_margin_;  ///< present where `stop_when` is located
  std::vector<std::size_t> ends_;          ///< places of diagnostics that end the run as `stop_when` does
  std::vector<std::size_t> faults_;        ///< places of those that end it as a fault
  bool may_stop_ = false;
  bool stop_changes_ = false;  ///< true if find_changing() evaluates `stop_when`
};

}  // namespace stepwire::run
