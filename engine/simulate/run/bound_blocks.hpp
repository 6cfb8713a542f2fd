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

/// One run's own copy of the blocks of a plan, bound to the numbers of that run, with the values that the run
/// begins with. The plan and the numbers must outlive it.
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
  /// Puts all numbers at time 0 and starts all blocks.
  void restart();
  void write_constants();
  /// Writes an input of the diagram, by its index in Diagram::inputs: as many numbers as it has elements.
  void write_input(std::size_t input, const double* numbers);

  /// Puts blocks, constants and initial values in the place of what was there. The numbers of the run stay.
  void apply(plan::PlanChange& change);
  /// Puts the present constants and initial values into a copy of the plan's diagram.
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
  /// Initial values that were set, in the place of the plan's.
  std::vector<std::pair<plan::SignalSlot, Eigen::VectorXd>> initial_;
  std::vector<Inputs::Element> list_elements_;   ///< of all list inputs, in the order of blocks in memory
  std::vector<std::size_t> first_list_element_;  ///< of each block
};

}  // namespace stepwire::run
