#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/units.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::plan {

/// Blocks in the order of their calls.
struct CallOrder {
  /// A part of the order that is an algebraic loop.
  struct Loop {
    std::size_t first, end;
    std::vector<diagram::SignalRef> tears;
    std::string path;
  };

  std::vector<int> blocks;  ///< a block occurs twice if its outputs cannot be computed in one call
  std::vector<Loop> loops;
};

/// A plan under construction, with the intermediate results for each block.
struct Draft {
  struct Block {
    Configuration says;                ///< Answers of configure().
    bool computes = false;             ///< It has an outputs() to call.
    bool differs_at_instants = false;  ///< It has another function for ticks and events.
    bool updates = false;
    bool updates_before_instant = false;
    bool in_stages = false;      ///< Derivatives depend on its outputs.
    bool timed = false;          ///< Its outputs depend on time and constants alone.
    Eigen::Index crossings = 0;  ///< Number of its crossing functions.
    bool for_crossings = false;  ///< Crossings depend on its outputs between ticks.
    bool ahead = false;          ///< Only the solver and time change its inputs as well.
    bool at_events = false;      ///< It acts where an event is located.
    bool before_guards = false;  ///< It acts first with the previous states of the guards as well.
    bool updates_at_events = false;
    bool for_left = false;  ///< An update just before an instant depends on its outputs.
    bool between = false;   ///< An external solver computes it between instants.
    bool on_sides = false;  ///< It is computed for a row just before an instant, or at the end of a run.
    std::vector<Eigen::Index> output_sizes, state_sizes, input_sizes;
    std::vector<Eigen::Index> output_columns, state_columns;  ///< columns of matrices; 1 for vectors
  };

  explicit Draft(Plan& plan) : plan(plan), report(plan.diagram), blocks(plan.diagram.blocks.size()) {}

  Plan& plan;
  diagram::Report report;
  std::vector<Block> blocks;
  std::vector<int> canonical;  ///< blocks in canonical_order(), once sizes are known

  diagram::Diagram& diagram() { return plan.diagram; }
  const BlockType& type(std::size_t block) const { return plan.diagram.blocks[block].type(); }
  /// True where this output depends on this input at the same instant.
  bool depends(std::size_t block, std::size_t input, std::size_t output) const;
  /// True where a block has states that may change.
  bool remembers(std::size_t block) const {
    const BlockType& of = type(block);
    return of.has_continuous_state() || (!of.states.empty() && !blocks[block].says.remembers_nothing);
  }
  /// True where its outputs are constant between located events.
  bool is_steady(std::size_t block) const {
    return plan.diagram.events.locate && (type(block).steady || blocks[block].says.steady);
  }
  /// True where this output is a state and needs no computation.
  bool is_state(std::size_t block, std::size_t output) const;
};

/// Returns the shapes of all outputs; an empty list if a size was refused.
diagram::OutputShapes output_shapes(const Draft& draft);
/// Plans the ticks of the run and all periods, and the rate of every block, inherited if the file gives none.
void plan_rates(Draft& draft);
/// Calls configure() of every block that has one.
void configure_blocks(Draft& draft);
/// Determines the sizes of all ports and states and expands per-element parameters.
void plan_shapes(Draft& draft);
/// Calls prepare() of every block that has one.
void prepare_blocks(Draft& draft);
/// Finds the blocks whose outputs depend on time and constants alone.
void find_timed(Draft& draft);
/// Orders the computation of outputs; refuses algebraic loops or tears them.
CallOrder plan_order(Draft& draft);
/// Finds the crossings and the blocks that act at located events.
void find_events(Draft& draft, const CallOrder& order);
/// Lays out the memory of blocks, numbers and loops.
void plan_layout(Draft& draft, const CallOrder& order);
/// Refuses stop conditions over signals of several elements, and safe values that do not fit their outputs.
void check_stop_and_safe_values(Draft& draft);
/// Builds the tables of kernel calls.
void make_schedule(Draft& draft, const CallOrder& order);

}  // namespace stepwire::plan
