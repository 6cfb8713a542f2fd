#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/model/plan/compiled_plan.hpp"
#include "engine/simulate/codegen/lane_places.hpp"
#include "engine/simulate/codegen/literals.hpp"
#include "engine/simulate/codegen/names.hpp"

namespace stepwire::codegen {

/// Where the statements of a function find their numbers: outputs that the function computes and states in
/// `fresh`, everything else in `w`, slopes in `dot`, also those that are outputs that it computes.
struct Places {
  std::string fresh = "w";
  std::vector<bool> is_fresh;  ///< by offset; empty: nothing is
  std::string dot = "w + first_derivative";
  std::size_t min_in_loop = 6;  ///< fewer calls stand one by one
};

/// A function of a block that a plan calls.
enum class Phase {
  outputs,
  outputs_at_instant,
  derivatives,
  update,
  update_at_event,
  start,
  crossings,
  next_edge  ///< which lowers a number called `edge`
};

/// Writes calls of blocks as C++: each block is an object of its own, set up and called on the spot, which
/// the compiler sees through.
class Statements {
 public:
  /// `variable` members are read from the numbers of a run, in the order of NumberTable. All but plan and
  /// `literals` must outlive it.
  Statements(const plan::Plan& plan, const PlaceNames& names,
             const std::vector<plan::VariableBlock>& variable, const LanePlaces& lanes, Literals& literals);

  const PlaceNames& names() const { return names_; }
  /// The call of one block.
  std::string call(std::size_t block, Phase phase, const Places& places) const;

  /// A piece of a block's set-up: text with a hole, and what fills it.
  struct Piece {
    std::string before, hole, after;
    std::int64_t offset = -1;  ///< where the hole is a place of the workspace
    bool fixed = false;        ///< is it a member that has the same value in each run?
  };
  using Pieces = std::vector<Piece>;
  /// Everything between the making of a block and its call; `complete` with members that keep their defaults.
  Pieces set_up(std::size_t block, const Places& places, bool complete) const;
  /// The making of a block, its set-up (members that are fixed, and the rest) and its call: in lanes the call
  /// is a loop over them.
  std::string call_text(std::size_t block, Phase phase, const std::string& fixed,
                        const std::string& rest) const;

 private:
  /// "w", or the lane of it that has a number.
  std::string in_lane(const std::string& numbers, std::size_t offset) const;
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
    bool is_default, fixed;
  };
  std::vector<std::vector<Member>> members_;  ///< of each block
};

/// The phase that a kernel runs, which may differ from `otherwise` at instants.
Phase phase_of(const BlockType& type, Kernel kernel, Phase otherwise);
/// "outputs", as the function is called.
const char* function_of(Phase phase);
/// "Gain"
std::string struct_of(const plan::Plan& plan, std::size_t block);

}  // namespace stepwire::codegen
