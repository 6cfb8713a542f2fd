#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/expression/matrix_expression.hpp"
#include "engine/model/block/spec.hpp"
#include "engine/model/diagram/diagram.hpp"

namespace stepwire::diagram {

class FaultReport;

/// Who gave a parameter another value than its definition: the call, or the file that uses its part.
struct GivenBy {
  Origin origin;
  std::string name;  ///< of the parameter: "rig.mass"
  std::string unit;  ///< of its definition, with a blank in front: " kg"
};

/// A value as a file writes it, before it is known what it is for.
struct WrittenValue {
  Value value;  ///< a number, vector or matrix in SI; a flag; text; a list of text
  std::optional<unit::Dimension> dimension;
  std::string text;     ///< as written, for messages
  bool failed = false;  ///< stands for a definition that was refused; what uses it stays silent
  std::optional<GivenBy> given{};  ///< of a text
  Eigen::Index columns = 1;  ///< of a matrix that is read as its elements, column by column
};

/// Parameters that a value was read from, by their index in Diagram::parameters.
using ParameterUses = std::vector<int>;

/// The parameters that expressions and `$name` of one file see.
class ParameterScope {
 public:
  /// The value of a parameter, and notes that something uses it; nullptr if there is none. `uses` gathers
  /// what can be evaluated again; without it the parameter decides what the diagram is made of, see
  /// is_structural.
  const WrittenValue* find(const std::string& name, ParameterUses* uses) const;
  bool defined(const std::string& name) const { return values_.contains(name); }
  void define(const std::string& name, WrittenValue value, int index = -1);
  /// Puts another value in the place of one that is defined, and returns the former.
  WrittenValue replace(const std::string& name, WrittenValue value);
  /// The value of a parameter that is defined, which is no use of it; else nullptr.
  const Value* value(const std::string& name) const;
  std::vector<std::string> names() const;
  bool failed(const std::string& name) const;
  /// Does anything use it?
  bool used(const std::string& name) const;
  /// Does anything use it that is not evaluated again: a file's times, records, words of presets?
  bool is_structural(const std::string& name) const;
  /// Does an expression of this file know the name: a parameter, or an element of one, "K.1.2"?
  bool knows(const std::string& name) const;
  /// The expression of a text that follows its '='; each text is parsed once. Null where it has brackets or
  /// functions of matrices. Throws ExpressionError.
  const expression::Expression* expression(const std::string& text) const;
  const expression::MatrixExpression& matrix_expression(const std::string& text) const;

 private:
  struct Entry {
    WrittenValue value;
    int index = -1;  ///< in Diagram::parameters
    mutable bool used = false, structural = false;
  };
  std::map<std::string, Entry> values_;
  // No value depends on what is parsed already.
  mutable std::map<std::string, std::optional<expression::Expression>> expressions_;
  mutable std::map<std::string, expression::MatrixExpression> matrix_expressions_;
};

/// Reads values of one file: numbers with units, `$name`, `= expression`, vectors, matrices, text.
class ValueReader {
 public:
  /// `uses` gathers the parameters that are read, where the reader of the values keeps how to read them
  /// again.
  ValueReader(const ParameterScope& parameters, FaultReport& report, int scope, ParameterUses* uses = nullptr)
      : parameters_(parameters), report_(report), scope_(scope), uses_(uses) {}

  /// A value whose purpose is open (a parameter's definition). Nothing, and a fault, if it cannot be read.
  std::optional<WrittenValue> read(const yaml::Node& node, const std::string& subject) const;
  /// A value for a parameter of a block: converted to its kind, its unit and range checked. `demanded` is the
  /// dimension of a fixed unit; nothing lets any unit pass.
  std::optional<WrittenValue> read_for(const ParameterSpec& spec,
                                       const std::optional<unit::Dimension>& demanded, const yaml::Node& node,
                                       const std::string& subject) const;
  /// One finite number of the given dimension.
  std::optional<double> read_number(const yaml::Node& node, const unit::Dimension& demanded,
                                    const std::string& subject) const;
  /// Replaces each `$name` inside of a text by that parameter's number or text, and `$$` by `$`.
  std::optional<std::string> fill_in(const yaml::Node& node, const std::string& subject) const;

  Origin at(const yaml::Mark& mark) const { return {scope_, mark}; }
  /// The value with a '=' before what can only be a formula of parameters: 2*k, and in rows of a matrix and
  /// where only numbers stand also k.
  yaml::Node with_formulas(const yaml::Node& node, bool only_numbers) const;

 private:
  bool is_bare_formula(const yaml::Node& node, bool only_number) const;
  std::optional<WrittenValue> read_variable(const std::string& name, const yaml::Node& node,
                                            const std::string& subject) const;
  std::optional<WrittenValue> read_matrices(const std::vector<WrittenValue>& values, const yaml::Node& node,
                                            const std::string& subject) const;
  std::optional<WrittenValue> read_scalar(const yaml::Node& node, const std::string& subject) const;
  std::optional<WrittenValue> read_list(const yaml::Node& node, const std::string& subject) const;
  std::optional<WrittenValue> read_rows(const yaml::Node& node, const std::string& subject) const;
  std::optional<WrittenValue> read_with_unit(const yaml::Node& node, const std::string& subject) const;
  std::optional<WrittenValue> read_expression(const yaml::Node& node, const std::string& subject) const;
  std::optional<WrittenValue> read_words(const ParameterSpec& spec, const yaml::Node& node,
                                         const std::string& subject) const;
  std::optional<Value> read_tree(const yaml::Node& node, const std::string& subject) const;
  std::optional<Value> convert(const ParameterSpec& spec, const WrittenValue& written, const yaml::Node& node,
                               const std::string& subject) const;
  bool in_range(const ParameterSpec& spec, const WrittenValue& written, const yaml::Node& node,
                const std::string& subject) const;
  std::string resolve_file(const std::string& text, const yaml::Node& node, const std::string& subject) const;
  std::nullopt_t refuse(const yaml::Node& node, const std::string& subject, yaml::Message message) const;
  /// Is it a text that somebody gave to a parameter of which a number is used? Then the fault is theirs.
  bool refuse_given(const WrittenValue& written) const;

  const ParameterScope& parameters_;
  FaultReport& report_;
  int scope_;
  ParameterUses* uses_;
};

/// The dimension of a parameter with a fixed unit; nothing where any unit passes, or one that wires decide.
std::optional<unit::Dimension> demanded_dimension(const ParameterSpec& spec);

/// The form of numbers that a wire or a state has: one or several, of any unit.
const ParameterSpec& numbers_of_any_unit();

/// Is this how YAML or C writes a number that is not finite (.inf, -nan, 1e999)?
bool means_not_finite(const std::string& text);

/// Checks that a dimension is the demanded one; a bare number always is. Says what is wrong otherwise.
std::string unit_complaint(const std::optional<unit::Dimension>& written,
                           const std::optional<unit::Dimension>& demanded);

}  // namespace stepwire::diagram
