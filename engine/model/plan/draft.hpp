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
  /// A part of it that is a loop.
  struct Loop {
    std::size_t first, end;
    std::vector<diagram::SignalRef> tears;
    std::string path;
  };

  std::vector<int> blocks;  ///< one whose outputs cannot be ordered as one stands twice
  std::vector<Loop> loops;
};

/// A plan while it is made: the plan itself and what is known of each block in between.
struct Draft {
  struct Block {
    Configuration says;                ///< what configure() answered
    bool computes = false;             ///< has outputs() to call
    bool differs_at_instants = false;  ///< and another function for ticks and events
    bool updates = false;
    bool in_stages = false;      ///< do derivatives depend on its outputs?
    bool timed = false;          ///< do its outputs follow from the time and constants alone?
    Eigen::Index crossings = 0;  ///< numbers that may cross zero
    bool for_crossings = false;  ///< do crossings depend on its outputs between ticks?
    bool ahead = false;          ///< and change only the solver and the time what it computes?
    bool at_events = false;      ///< does it act where an event is located?
    bool before_guards = false;  ///< and first with the guards as they were?
    bool updates_at_events = false;
    bool on_sides = false;  ///< is it computed for a row just before an instant, or at the end of a run?
    std::vector<Eigen::Index> output_sizes, state_sizes, input_sizes;
    std::vector<Eigen::Index> output_columns, state_columns;  ///< of matrices; 1 of vectors
  };

  explicit Draft(Plan& plan) : plan(plan), report(plan.diagram), blocks(plan.diagram.blocks.size()) {}

  Plan& plan;
  diagram::Report report;
  std::vector<Block> blocks;
  std::vector<int> canonical;  ///< blocks in canonical_order(), once sizes are known

  diagram::Diagram& diagram() { return plan.diagram; }
  const BlockType& type(std::size_t block) const { return plan.diagram.blocks[block].type(); }
  /// Does this output change at once when this input does?
  bool depends(std::size_t block, std::size_t input, std::size_t output) const;
  /// True where a block has states that may change.
  bool remembers(std::size_t block) const {
    return !type(block).states.empty() && !blocks[block].says.remembers_nothing;
  }
  /// Tells whether its outputs are constant between events, with these located.
  bool is_steady(std::size_t block) const {
    return plan.diagram.events.locate && (type(block).steady || blocks[block].says.steady);
  }
  /// Is this output a state, without computation?
  bool is_state(std::size_t block, std::size_t output) const;
};

/// The shapes of all outputs; an empty list where some were refused.
diagram::OutputShapes output_shapes(const Draft& draft);
/// Ticks of the run and of every period; the rate of every block, inherited where the file gives none.
void plan_rates(Draft& draft);
/// Asks every block that has configure().
void configure_blocks(Draft& draft);
/// Sizes of all ports and states; expands per-element parameters.
void plan_shapes(Draft& draft);
/// Lets every block compute what follows from its parameters, sizes and period.
void prepare_blocks(Draft& draft);
/// Finds the blocks whose outputs follow from the time and constants alone.
void find_timed(Draft& draft);
/// Order of outputs; refuses algebraic loops, or tears them.
CallOrder plan_order(Draft& draft);
/// What crosses, and what acts where it does.
void find_events(Draft& draft, const CallOrder& order);
/// Memory of blocks, numbers and loops.
void plan_layout(Draft& draft, const CallOrder& order);
/// Refuses conditions over signals of several elements, and safe values that do not fit their outputs.
void check_stop_and_safe_values(Draft& draft);
/// The tables of calls.
void make_schedule(Draft& draft, const CallOrder& order);

}  // namespace stepwire::plan
