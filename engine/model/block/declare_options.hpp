#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/model/block/block_type.hpp"

namespace stepwire {

// What a declaration says of a block and its members.

struct BlockOptions {
  std::string doc;
  std::string source = "";
  Timing timing = Timing::inherited;
  /// Why a real-time loop refuses the block: "reads a file at every step". Left out where no step allocates,
  /// locks, calls the system, or takes a time that nothing bounds.
  std::string not_real_time = "";
  /// Why linear analyses refuse the block: what it does is no linear system of its states around a point.
  std::string not_linear = "";
  Symbol symbol{};
  /// Are the outputs constant between crossings?
  bool steady = false;
  /// Lets a block that remembers act at located events, too, without `every`. It must not count
  /// on its period.
  bool at_events = false;
  /// Promises that outputs jump only where an input or a reset does, never by the time alone.
  bool smooth = false;
  /// Are algebraic loops through it solved for its outputs? They begin with what start() leaves there.
  bool torn = false;
  /// The header that declares the struct, from the folder of the source that declares the block; needed where
  /// it has another name, or lies in another folder.
  std::string header = "";
};

struct ParameterOptions {
  std::string unit = "1";
  std::string shape = "";
  std::string doc;
  std::optional<double> above{}, below{}, at_least{}, at_most{};
  std::vector<std::string> words{};
  bool required = false;
  /// Do sizes or connections of the block follow from the number? Another one takes another plan then, and a
  /// generated program keeps it.
  bool structural = false;
  /// Keys of a tree whose texts, and those in a map there, are expressions; "to." for the map alone; {""}
  /// where the text itself is one. Names of parameters in them are the parameters' numbers, but for those
  /// that the block gives a meaning: its inputs, what `variables` lists, u1, u2, .. and time.
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
  /// The state is 0 before the first instant and 1 from then on. A linear analysis takes it for 1.
  bool marks_start = false;
};

struct DiagnosticOptions {
  std::string doc;
  bool ends_run = false;
  bool is_fault = true;  ///< false: the run that it ends is whole, as with `stop_when`
};

}  // namespace stepwire
