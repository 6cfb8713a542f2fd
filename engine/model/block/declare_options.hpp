#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/model/block/block_type.hpp"

namespace stepwire {

// Properties of a block in its declaration; the following types are those of its members.

struct BlockOptions {
  std::string doc;
  std::string source = "";
  Timing timing = Timing::inherited;
  /// Reason why a real-time loop refuses the block: "reads a file at every step". Empty if no step allocates,
  /// locks, makes a system call or has an unbounded duration.
  std::string not_real_time = "";
  /// Name of the input that has the delay time [s] of an exact delay. The first output is the first input,
  /// which has no feedthrough, this time ago. Linear analyses put exp(-s T) in the place of the block.
  std::string delayed_by = "";
  Symbol symbol{};
  /// The outputs are constant between crossings.
  bool steady = false;
  /// Lets a block with memory act at located events as well, if it has no `every`. It must not rely on its
  /// period.
  bool at_events = false;
  /// Calls update() at the last row of a run, too, where no step follows, since it judges the present values
  /// and raises diagnostics. Nothing reads what else it changes there.
  bool at_end = false;
  /// Promises that outputs jump only where an input or a reset does, never by time alone.
  bool smooth = false;
  /// Algebraic loops through the block are solved for its outputs. The iteration begins at the values that
  /// start() sets.
  bool torn = false;
  /// Header that declares the struct, relative to the folder of the declaring source. Needed for a header of
  /// another name or folder.
  std::string header = "";
};

struct ParameterOptions {
  std::string unit = "1";
  std::string shape = "";
  std::string doc;
  std::optional<double> above{}, below{}, at_least{}, at_most{};
  std::vector<std::string> words{};
  bool required = false;
  /// Sizes or connections of the block depend on the number. A change needs a new plan, and a generated
  /// program keeps the value.
  bool structural = false;
  /// Keys of a tree whose texts, and those of a nested map, are expressions; "to." for the nested map alone;
  /// {""} where the text itself is one. Names in them are parameters of the diagram, except for names that
  /// the block defines: its inputs, the list `variables`, u1, u2, .. and time.
  std::vector<std::string> formulas{};
};

struct InputOptions {
  std::string unit = "1";
  std::string shape = "";
  std::string doc;
  bool feedthrough = true;
  bool optional = false;
  bool multiply_units = false;
};

struct OutputOptions {
  std::string unit = "1";
  std::string shape = "";
  std::string doc;
};

struct StateOptions {
  std::string unit = "1";
  std::string shape = "";
  std::string doc;
  double initial = 0.0;
  bool settable = true;
  /// The state is 0 before the first instant and 1 afterwards. A linear analysis treats it as 1.
  bool marks_start = false;
};

struct DiagnosticOptions {
  std::string doc;
  bool ends_run = false;
  bool is_fault = true;  ///< false: the run that it ends is complete, as with `stop_when`
};

}  // namespace stepwire
