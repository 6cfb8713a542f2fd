#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/model/plan/compiled_plan.hpp"
#include "engine/simulate/codegen/lane_places.hpp"
#include "engine/simulate/codegen/literals.hpp"
#include "engine/simulate/codegen/names.hpp"

namespace stepwire::codegen {

/// Names of the arrays that hold the numbers of a function. Outputs that the function computes and states are
/// in `fresh`, all others in `w`, and derivatives in `dot`, including those that are outputs that it
/// computes.
struct Places {
  std::string fresh = "w";
  std::vector<bool> is_fresh;  ///< by offset; an empty list if no number is fresh
  std::string dot = "w + first_derivative";
  std::size_t min_in_loop = 6;        ///< Smallest number of calls that is written as a loop.
  const LanePlaces* lanes = nullptr;  ///< Others than those of the program; nullptr for none.
};

/// Function of a block that a plan calls.
enum class Phase {
  outputs,
  outputs_at_instant,
  derivatives,
  update,
  update_at_event,
  update_before_instant,
  start,
  crossings,
  next_edge  ///< lowers a number named `edge`
};

/// Writes calls of blocks as C++. Each block is a local object that is set up and called on the spot, so the
/// compiler can optimise it away.
class Statements {
 public:
  /// `variable` members are read from the numbers of a run, in the order of NumberTable. All arguments except
  /// the plan and `literals` must outlive it.
  Statements(const plan::Plan& plan, const PlaceNames& names,
             const std::vector<plan::VariableBlock>& variable, const LanePlaces& lanes, Literals& literals);

  const PlaceNames& names() const { return names_; }
  /// Returns the call of one block.
  std::string call(std::size_t block, Phase phase, const Places& places) const;

  /// Piece of a block's set-up: text with a placeholder, and its content.
  struct Piece {
    std::string before, hole, after;
    std::int64_t offset = -1;  ///< place of the workspace, if the content is one
  };
  using Pieces = std::vector<Piece>;
  /// Returns all statements before the call of a block, first its declaration; `complete` includes members
  /// that keep their defaults.
  Pieces set_up(std::size_t block, const Places& places, bool complete) const;
  /// Returns the set-up of a block and its call, in lanes as a loop over them.
  std::string call_text(std::size_t block, Phase phase, const std::string& set_up,
                        const Places& places = {}) const;

 private:
  std::string declaration(std::size_t block) const;
  /// Returns "w", or its lane that has a number.
  std::string in_lane(const std::string& numbers, std::size_t offset, const Places& places) const;
  const LanePlaces& lanes(const Places& places) const { return places.lanes ? *places.lanes : lanes_; }
  Piece place(const std::string& before, std::size_t offset, const std::string& after,
              const Places& places) const;
  void bind_inputs(std::size_t block, const Places& places, Pieces& pieces) const;
  void bind_outputs(std::size_t block, const Places& places, Pieces& pieces) const;
  void bind_states(std::size_t block, const Places& places, Pieces& pieces) const;
  void bind_rest(std::size_t block, const Places& places, Pieces& pieces) const;

  const plan::Plan& plan_;
  const PlaceNames& names_;
  const LanePlaces& lanes_;
  struct Member {
    std::string name, value;
    bool is_default;
  };
  std::vector<std::vector<Member>> members_;  ///< of each block
  std::vector<std::string> functions_;        ///< name of the type of a block's functions, or empty
};

/// Returns the phase that a kernel runs, which may differ from `otherwise` at instants.
Phase phase_of(const BlockType& type, Kernel kernel, Phase otherwise);
/// Returns the name of the function, "outputs".
const char* function_of(Phase phase);
/// Returns "Gain", or "ExpressionOf<Code>" for a block over the type of its functions.
std::string struct_of(const plan::Plan& plan, std::size_t block);

}  // namespace stepwire::codegen
