#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/block/value.hpp"
#include "engine/model/signal/input.hpp"

namespace stepwire {

class LiteralWriter;

/// What kind of YAML value a parameter takes; it follows from the member's C++ type.
enum class ParameterKind {
  number,       ///< double
  integer,      ///< std::int64_t
  flag,         ///< bool
  word,         ///< an enum: one of `words`, in the order of its values
  text,         ///< std::string
  file,         ///< FilePath, beside the diagram file or under the data folder
  per_element,  ///< PerElement: one number for all elements or one for each
  vector,       ///< Numbers: a list of numbers of its own length
  matrix,       ///< Matrix: a list of rows
  texts,        ///< std::vector<std::string>
  tree          ///< Tree: maps and lists that the block reads itself
};

/// A range for numbers; every element of a vector or matrix is held to it.
struct Range {
  std::optional<double> above, below, at_least, at_most;
};

/// How a parameter is declared, and how its value gets in and out of a block.
struct ParameterSpec {
  std::string name;
  ParameterKind kind = ParameterKind::number;
  std::string unit;   ///< as parse_unit reads it, a unit variable such as 'u, or "*" for any
  std::string shape;  ///< "n", "n x m", or empty for its own length
  std::string doc;
  Range range;
  std::vector<std::string> words;
  bool required = false;
  bool structural = false;            ///< another number takes another plan
  std::vector<std::string> formulas;  ///< see ParameterOptions
  int member = -1;                    ///< index in BlockType::members; -1 where no run reads it
  void (*set)(void* block, const Value& value) = nullptr;
  Value (*get)(const void* block) = nullptr;
};

/// The numbers of a member that prepare() computes; null for every other one. See PreparedParts.
struct PreparedMember {
  Eigen::Index (*count)(const void* block) = nullptr;  ///< 0 where so many would take memory
  std::string (*text)(Eigen::Index k) = nullptr;       ///< number k in C++, behind the member's name: ".A"
  void (*put)(void* block, const double* numbers, Eigen::Index count) = nullptr;
  bool by_element = false;  ///< does number k follow from the elements k of other members?
};

/// A member that a run reads and never changes, a parameter or what follows from parameters, as a program may
/// set it.
struct MemberSpec {
  std::string member;  ///< its name in C++
  /// The value as an expression of C++.
  std::string (*literal)(const void* block, LiteralWriter& writer) = nullptr;
  PreparedMember prepared{};
  /// The parameters whose numbers it is computed from; all of them where the declaration names none.
  std::optional<std::vector<std::string>> follows{};
};

/// How an input is declared.
struct InputSpec {
  std::string name, unit, shape, doc;
  std::string member;       ///< its name in C++
  bool feedthrough = true;  ///< do the outputs depend on it at the same instant?
  bool optional = false;
  bool list = false;
  bool multiply_units = false;  ///< a list whose unit variable stands for the product of its elements' units
  void (*bind)(void* block, const double* data, Eigen::Index size) = nullptr;  ///< null for a list
  void (*bind_list)(void* block, const Inputs::Element* elements,
                    Eigen::Index count) = nullptr;  ///< null otherwise
  void (*unbind)(void* block) = nullptr;
};

/// How an output is declared.
struct OutputSpec {
  std::string name, unit, shape, doc;
  std::string member;  ///< its name in C++
  std::string state;   ///< name of the continuous state that it is, or empty
  void (*bind)(void* block, double* data, Eigen::Index size) = nullptr;
};

/// How a state is declared.
struct StateSpec {
  std::string name, unit, shape, doc;
  std::string member;  ///< its name in C++
  bool continuous = true;
  bool settable = true;  ///< may a file give its initial value?
  double initial = 0.0;
  bool marks_start = false;  ///< 0 before the first instant, then 1
  void (*bind)(void* block, double* data, double* derivative, Eigen::Index size) = nullptr;
};

/// How a diagnostic is declared.
struct DiagnosticSpec {
  std::string name, doc;
  std::string member;  ///< its name in C++
  bool ends_run = false;
  bool is_fault = true;  ///< false: the run that it ends is whole, as with `stop_when`
  void (*bind)(void* block, double* first) = nullptr;
  std::string (*detail)(const void* block) = nullptr;  ///< names and numbers of the case, once it is raised
};

/// How a function is declared that passes through zero where the block begins to do something else.
struct CrossingSpec {
  std::string doc, shape;
  std::vector<std::string> inputs;  ///< that it reads
};

/// How a member that tells the time, or the time between updates, is bound.
struct ClockSpec {
  std::string member;                                            ///< its name in C++
  void (*bind_time)(void* block, const double* time) = nullptr;  ///< null for a period
  void (*bind_period)(void* block, double period) = nullptr;     ///< null for the time
};

/// A member that holds a size of the block, by its letter in the declared shapes.
struct SizeSpec {
  std::string symbol;
  void (*set)(void* block, Eigen::Index elements) = nullptr;
};

/// A named set of parameter values that a file chooses by `preset:`.
struct PresetSpec {
  std::string name, doc;
  void (*apply)(void* block) = nullptr;
};

}  // namespace stepwire
