#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/block/value.hpp"
#include "engine/model/signal/input.hpp"

namespace stepwire {

class LiteralWriter;

/// Kind of YAML value of a parameter; it follows from the member's C++ type.
enum class ParameterKind {
  number,       ///< For double.
  integer,      ///< For std::int64_t.
  flag,         ///< For bool.
  word,         ///< For an enum: one of `words`, in the order of its values.
  text,         ///< For std::string.
  file,         ///< For FilePath: beside the diagram file or below the data folder.
  per_element,  ///< For PerElement: one number for all elements or one for each.
  vector,       ///< For Numbers: a list of numbers of its own length.
  matrix,       ///< For Matrix: a list of rows.
  texts,        ///< For std::vector<std::string>.
  tree          ///< For Tree: maps and lists that the block reads itself.
};

/// Allowed range of a number, or of every element of a vector or matrix.
struct Range {
  std::optional<double> above, below, at_least, at_most;
};

/// Declaration of a parameter, with access to its value in a block.
struct ParameterSpec {
  std::string name;
  ParameterKind kind = ParameterKind::number;
  std::string unit;   ///< for parse_unit, a unit variable such as 'u, or "*" for any
  std::string shape;  ///< "n", "n x m", or empty for its own length
  std::string doc;
  Range range;
  std::vector<std::string> words;
  bool required = false;
  bool structural = false;            ///< a change needs another plan
  std::vector<std::string> formulas;  ///< see ParameterOptions
  int member = -1;                    ///< index in BlockType::members; -1 if no run reads it
  void (*set)(void* block, const Value& value) = nullptr;
  Value (*get)(const void* block) = nullptr;
};

/// Access to the numbers of a member that prepare() computes, see PreparedParts. All pointers are nullptr for
/// other members.
struct PreparedMember {
  Eigen::Index (*count)(const void* block) = nullptr;  ///< 0 where the numbers would need heap memory
  std::string (*text)(Eigen::Index k) = nullptr;       ///< C++ suffix of number k, ".A"
  void (*put)(void* block, const double* numbers, Eigen::Index count) = nullptr;
  bool by_element = false;  ///< number k depends only on the elements k of other members
};

/// A member that a run reads and never changes: a parameter or a value derived from parameters.
struct MemberSpec {
  std::string member;  ///< C++ name
  /// Returns the value as a C++ expression.
  std::string (*literal)(const void* block, LiteralWriter& writer) = nullptr;
  PreparedMember prepared{};
  /// Parameters that it depends on; std::nullopt for all.
  std::optional<std::vector<std::string>> follows{};
};

/// Declaration of an input.
struct InputSpec {
  std::string name, unit, shape, doc;
  std::string member;       ///< C++ name
  bool feedthrough = true;  ///< the outputs depend on it at the same instant
  bool optional = false;
  bool list = false;
  bool multiply_units = false;  ///< a list whose unit variable is the product of its elements' units
  bool one_unit = false;        ///< elements in different units are refused
  void (*bind)(void* block, const double* data, Eigen::Index size) = nullptr;  ///< nullptr for a list
  void (*bind_list)(void* block, const Inputs::Element* elements,
                    Eigen::Index count) = nullptr;  ///< nullptr for a single input
  void (*unbind)(void* block) = nullptr;
};

/// Declaration of an output.
struct OutputSpec {
  std::string name, unit, shape, doc;
  std::string member;  ///< C++ name
  std::string state;   ///< continuous state that it is identical to; may be empty
  void (*bind)(void* block, double* data, Eigen::Index size) = nullptr;
};

/// Declaration of a state.
struct StateSpec {
  std::string name, unit, shape, doc;
  std::string member;  ///< C++ name
  bool continuous = true;
  bool settable = true;  ///< a file may set its initial value
  double initial = 0.0;
  bool marks_start = false;  ///< 0 before the first instant, then 1
  void (*bind)(void* block, double* data, double* derivative, Eigen::Index size) = nullptr;
};

/// Declaration of a diagnostic.
struct DiagnosticSpec {
  std::string name, doc;
  std::string member;  ///< C++ name
  bool ends_run = false;
  bool is_fault = true;  ///< false: the run that it ends is complete, as with `stop_when`
  void (*bind)(void* block, double* first) = nullptr;
  std::string (*detail)(const void* block) = nullptr;  ///< names and numbers for the message
};

/// Declaration of a function that crosses zero where the block's behaviour changes.
struct CrossingSpec {
  std::string doc, shape;
  std::vector<std::string> inputs;  ///< inputs that it depends on
  bool if_connected = false;        ///< true if it has numbers only where the first of them is connected
};

/// Binding of a member that holds the time, or the time between updates.
struct ClockSpec {
  std::string member;                                            ///< C++ name
  void (*bind_time)(void* block, const double* time) = nullptr;  ///< nullptr for a period
  void (*bind_period)(void* block, double period) = nullptr;     ///< nullptr for the time
};

/// A member that holds a size of the block, by its letter in the declared shapes.
struct SizeSpec {
  std::string symbol;
  void (*set)(void* block, Eigen::Index elements) = nullptr;
};

/// A named set of parameter values that a file selects by `preset:`.
struct PresetSpec {
  std::string name, doc;
  void (*apply)(void* block) = nullptr;
};

}  // namespace stepwire
