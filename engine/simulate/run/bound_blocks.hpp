#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "engine/model/plan/change.hpp"
#include "engine/model/plan/plan.hpp"
#include "engine/model/signal/input.hpp"

namespace stepwire::run {

/// Copies of a plan's blocks for one run, bound to the numbers of that run, and the initial values of the
/// run. The plan and the numbers must outlive it.
class BoundBlocks {
 public:
  BoundBlocks(const plan::Plan& plan, double* values);
  ~BoundBlocks();
  BoundBlocks(const BoundBlocks&) = delete;
  BoundBlocks& operator=(const BoundBlocks&) = delete;

  const plan::Plan& plan() const { return plan_; }
  double* values() const { return values_; }
  std::byte* memory() const { return memory_.get(); }
  void* memory(std::size_t block) const { return memory_.get() + plan_.blocks[block].memory; }

  void start(std::size_t block) { plan_.diagram.blocks[block].type().start(memory(block)); }
  /// Sets all numbers to their values at time 0 and starts all blocks.
  void restart();
  void write_constants();
  /// Writes an input of the diagram, by its index in Diagram::inputs. `numbers` has one number for each
  /// element.
  void write_input(std::size_t input, const double* numbers);

  /// Replaces blocks, constants and initial values. The numbers of the run stay.
  void apply(plan::PlanChange& change);
  /// Writes the present constants and initial values into a copy of the plan's diagram.
  void put_numbers(diagram::Diagram& diagram) const;

 private:
  void bind(std::size_t block);
  void replace(plan::RebuiltBlock& rebuilt);
  void set_constant(const plan::SignalSlot& slot, const Eigen::VectorXd& value);
  void set_initial(const plan::SignalSlot& slot, const Eigen::VectorXd& value);

  struct FreeMemory {
    void operator()(std::byte* memory) const;
  };

  const plan::Plan& plan_;
  double* const values_;
  std::unique_ptr<std::byte, FreeMemory> memory_;
  std::vector<double> constants_;
  /// Initial values that were set; they override those of the plan.
  std::vector<std::pair<plan::SignalSlot, Eigen::VectorXd>> initial_;
  std::vector<Inputs::Element> list_elements_;   ///< all list inputs, in memory order of blocks
  std::vector<std::size_t> first_list_element_;  ///< index into list_elements_ for each block
};

}  // namespace stepwire::run
