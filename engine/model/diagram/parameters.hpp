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

/// Origin of a value that replaces a definition's own: the call, or the file that uses the part.
struct GivenBy {
  Origin origin;
  std::string name;  ///< full name of the parameter: "rig.mass"
  std::string unit;  ///< of its definition, with a leading blank: " kg"
};

/// A value as written in a file, before its purpose is known.
struct WrittenValue {
  Value value;  ///< a number, vector or matrix in SI; a flag; text; a list of texts
  std::optional<unit::Dimension> dimension;
  std::string text;                ///< as written, for messages
  bool failed = false;             ///< replaces a refused definition; its uses add no further faults
  std::optional<GivenBy> given{};  ///< set for a text
  Eigen::Index columns = 1;        ///< of a matrix in column-major order
  EachUnit each{};                 ///< units of elements in several; `dimension` is then nullopt
};

/// Parameters used by a value, as indices in Diagram::parameters.
using ParameterUses = std::vector<int>;

/// Parameters visible to expressions and `$name` of one file.
class ParameterScope {
 public:
  /// Returns the value of a parameter and records its use; nullptr if it is missing. `uses` collects the
  /// parameters of a value that can be evaluated again. Without it the parameter determines the structure of
  /// the diagram, see is_structural.
  const WrittenValue* find(const std::string& name, ParameterUses* uses) const;
  bool defined(const std::string& name) const { return values_.contains(name); }
  void define(const std::string& name, WrittenValue value, int index = -1);
  /// Replaces the value of a defined parameter and returns the previous one.
  WrittenValue replace(const std::string& name, WrittenValue value);
  /// Returns the value of a defined parameter without recording a use; nullptr if it is missing.
  const Value* value(const std::string& name) const;
  std::vector<std::string> names() const;
  bool failed(const std::string& name) const;
  /// True where the parameter has a use.
  bool used(const std::string& name) const;
  /// True where it has a use that is never evaluated again: times of a file, records, words of presets.
  bool is_structural(const std::string& name) const;
  /// True for a parameter, or an element of one, "K.1.2", as a name in an expression.
  bool knows(const std::string& name) const;
  /// Returns the parsed expression of a text after its '='; each text is parsed only once. Returns nullptr
  /// for a text with brackets or matrix functions. Throws ExpressionError.
  const expression::Expression* expression(const std::string& text) const;
  const expression::MatrixExpression& matrix_expression(const std::string& text) const;

 private:
  struct Entry {
    WrittenValue value;
    int index = -1;  ///< index in Diagram::parameters
    mutable bool used = false, structural = false;
  };
  std::map<std::string, Entry> values_;
  // Caches of parsed expressions; they have no influence on values.
  mutable std::map<std::string, std::optional<expression::Expression>> expressions_;
  mutable std::map<std::string, expression::MatrixExpression> matrix_expressions_;
};

/// Reads values of one file: numbers with units, `$name`, `= expression`, vectors, matrices, text.
class ValueReader {
 public:
  /// `uses` collects the parameters that are read, for values that can be read again.
  ValueReader(const ParameterScope& parameters, FaultReport& report, int scope, ParameterUses* uses = nullptr)
      : parameters_(parameters), report_(report), scope_(scope), uses_(uses) {}

  /// Reads a value of any kind, as for the definition of a parameter. Adds a fault and returns std::nullopt
  /// for an invalid one.
  std::optional<WrittenValue> read(const yaml::Node& node, const std::string& subject) const;
  /// Reads a value of a block's parameter: converts it to its kind and checks unit and range. `demanded` is
  /// the dimension of a fixed unit; std::nullopt allows any unit.
  std::optional<WrittenValue> read_for(const ParameterSpec& spec,
                                       const std::optional<unit::Dimension>& demanded, const yaml::Node& node,
                                       const std::string& subject) const;
  /// Reads one finite number of the given dimension.
  std::optional<double> read_number(const yaml::Node& node, const unit::Dimension& demanded,
                                    const std::string& subject) const;
  /// Replaces each `$name` inside of a text by that parameter's number or text, and `$$` by `$`. In formulas
  /// numbers have their units.
  std::optional<std::string> fill_in(const yaml::Node& node, const std::string& subject,
                                     bool is_formula = false) const;

  Origin at(const yaml::Mark& mark) const { return {scope_, mark}; }
  /// Returns the value with '=' before texts that can only be formulas of parameters: 2*k. In rows of a
  /// matrix and in lists of numbers, k alone is a formula, too.
  yaml::Node with_formulas(const yaml::Node& node, bool only_numbers) const;

 private:
  bool is_bare_formula(const yaml::Node& node, bool only_number) const;
  std::optional<WrittenValue> read_variable(const std::string& name, const yaml::Node& node,
                                            const std::string& subject) const;
  std::optional<WrittenValue> read_matrices(const std::vector<WrittenValue>& values, const yaml::Node& node,
                                            const std::string& subject) const;
  std::optional<WrittenValue> read_scalar(const yaml::Node& node, const std::string& subject) const;
  std::optional<WrittenValue> read_text(const yaml::Node& node, const std::string& subject) const;
  std::optional<WrittenValue> read_list(const yaml::Node& node, const std::string& subject) const;
  std::optional<WrittenValue> read_rows(const yaml::Node& node, const std::string& subject) const;
  std::optional<WrittenValue> read_with_unit(const yaml::Node& node, const std::string& subject) const;
  std::optional<WrittenValue> read_expression(const yaml::Node& node, const std::string& subject) const;
  std::optional<WrittenValue> read_words(const ParameterSpec& spec, const yaml::Node& node,
                                         const std::string& subject) const;
  std::optional<Value> read_tree(const yaml::Node& node, const std::string& subject, bool has_formulas) const;
  bool has_wrong_unit(const ParameterSpec& spec, const WrittenValue& written,
                      const std::optional<unit::Dimension>& demanded, const yaml::Node& node,
                      const std::string& subject) const;
  std::optional<Value> convert(const ParameterSpec& spec, const WrittenValue& written, const yaml::Node& node,
                               const std::string& subject) const;
  bool in_range(const ParameterSpec& spec, const WrittenValue& written, const yaml::Node& node,
                const std::string& subject) const;
  std::string resolve_file(const std::string& text, const yaml::Node& node, const std::string& subject) const;
  std::nullopt_t refuse(const yaml::Node& node, const std::string& subject, yaml::Message message) const;
  /// Adds the fault at the origin of a text that was given to a parameter in place of a number. Returns false
  /// for other values.
  bool refuse_given(const WrittenValue& written) const;

  const ParameterScope& parameters_;
  FaultReport& report_;
  int scope_;
  ParameterUses* uses_;
};

/// Returns the dimension of a parameter with a fixed unit; std::nullopt if any unit is allowed, or wires
/// determine it.
std::optional<unit::Dimension> demanded_dimension(const ParameterSpec& spec);

/// Returns the form of numbers on a wire or in a state: one or several, of any unit.
const ParameterSpec& numbers_of_any_unit();

/// True for a non-finite number in the notation of YAML or C (.inf, -nan, 1e999).
bool means_not_finite(const std::string& text);

/// Returns a complaint if a dimension differs from the demanded one; empty if they agree and for a bare
/// number.
std::string unit_complaint(const std::optional<unit::Dimension>& written,
                           const std::optional<unit::Dimension>& demanded);

/// Returns the index of the first element whose unit differs from the demanded one; std::nullopt without one.
std::optional<std::size_t> wrong_element(const EachUnit& written,
                                         const std::optional<unit::Dimension>& demanded);

/// Returns the fault of a value in another unit than the demanded one, "5 N is in N; it must be in m"; empty
/// if they agree.
std::string unit_fault(const WrittenValue& written, const std::optional<unit::Dimension>& demanded);

}  // namespace stepwire::diagram
