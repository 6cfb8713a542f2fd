#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/simulate/run/bound_blocks.hpp"
#include "engine/simulate/run/stop_condition.hpp"

namespace stepwire::run {

/// The numbers whose change of sign is an event, and the edges that sources declare.
class CrossingLooks {
 public:
  explicit CrossingLooks(BoundBlocks& blocks);

  void find(double* numbers) const;
  /// Those alone that may have changed although time and states did not.
  void find_changing(double* numbers) const;
  /// When a source jumps or bends next [s]; infinite where none does.
  double next_edge() const;
  /// True once `stop_when` is, where it is located, or a block has ended the run.
  bool stops() const;
  bool may_stop() const { return stop_margin_.has_value(); }

 private:
  /// The crossings of a block.
  struct Look {
    void (*run)(const void* block, double* numbers);
    const void* block;
    const double* active;  ///< 0 while it crosses nothing
    std::size_t first, count;
  };
  struct Edge {
    double (*next)(const void* block);
    const void* block;
  };

  void add(const plan::CrossingCall& call, const std::vector<bool>& settled);
  void add_stop(const std::vector<bool>& settled);
  static void find(const std::vector<Look>& looks, double* numbers);

  const plan::Plan& plan_;
  const BoundBlocks& blocks_;
  const double* const values_;
  std::vector<Look> looks_, changing_;
  std::vector<Edge> edges_;
  std::optional<StopMargin> stop_margin_;  ///< where `stop_when` is located
  std::vector<std::size_t> ends_;          ///< places of diagnostics that end the run as `stop_when` does
  bool stop_changes_ = false;              ///< is its number one of those that may have changed?
};

}  // namespace stepwire::run
