#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/block/spec.hpp"
#include "engine/diagram/report.hpp"

namespace stepwire {

/// A value as a file writes it, before it is known what it is for.
struct WrittenValue {
  Value value;  ///< a number, vector or matrix in SI; a flag; text; a list of text
  std::optional<Dimension> dimension;
  std::string text;     ///< as written, for messages
  bool failed = false;  ///< stands for a definition that was refused; what uses it stays silent
};

/// The parameters that expressions and `$name` of one file see.
class ParameterScope {
 public:
  /// The value of a parameter that something uses; nullptr if there is none.
  const WrittenValue* find(const std::string& name) const;
  bool defined(const std::string& name) const { return values_.contains(name); }
  void define(const std::string& name, WrittenValue value) { values_[name] = std::move(value); }
  std::vector<std::string> names() const;
  bool failed(const std::string& name) const;
  /// Has it ever been asked for?
  bool used(const std::string& name) const { return used_.contains(name); }

 private:
  std::map<std::string, WrittenValue> values_;
  mutable std::set<std::string> used_;  // kept for messages only: no value depends on it
};

/// Reads values of one file: numbers with units, `$name`, `= expression`, vectors, matrices, text.
class ValueReader {
 public:
  ValueReader(const ParameterScope& parameters, Report& report, int scope)
      : parameters_(parameters), report_(report), scope_(scope) {}

  /// A value whose purpose is open (a parameter's definition). Nothing, and a fault, if it cannot be read.
  std::optional<WrittenValue> read(const Node& node, const std::string& subject) const;
  /// A value for a parameter of a block: converted to its kind, its unit and range checked. `demanded` is the
  /// dimension of a fixed unit; nothing lets any unit pass.
  std::optional<WrittenValue> read_for(const ParameterSpec& spec, const std::optional<Dimension>& demanded,
                                       const Node& node, const std::string& subject) const;
  /// One finite number of the given dimension.
  std::optional<double> read_number(const Node& node, const Dimension& demanded,
                                    const std::string& subject) const;
  /// Replaces each `$name` inside of a text by that parameter's number or text, and `$$` by `$`.
  std::optional<std::string> fill_in(const Node& node, const std::string& subject) const;

  Origin at(const Mark& mark) const { return {scope_, mark}; }

 private:
  std::optional<WrittenValue> read_scalar(const Node& node, const std::string& subject) const;
  std::optional<WrittenValue> read_list(const Node& node, const std::string& subject) const;
  std::optional<WrittenValue> read_rows(const Node& node, const std::string& subject) const;
  std::optional<WrittenValue> read_with_unit(const Node& node, const std::string& subject) const;
  std::optional<WrittenValue> read_expression(const Node& node, const std::string& subject) const;
  std::optional<WrittenValue> read_words(const ParameterSpec& spec, const Node& node,
                                         const std::string& subject) const;
  std::optional<Value> read_tree(const Node& node, const std::string& subject) const;
  std::optional<Value> convert(const ParameterSpec& spec, const WrittenValue& written, const Node& node,
                               const std::string& subject) const;
  bool in_range(const ParameterSpec& spec, const WrittenValue& written, const Node& node,
                const std::string& subject) const;
  std::string resolve_file(const std::string& text, const Node& node, const std::string& subject) const;
  std::nullopt_t refuse(const Node& node, const std::string& subject, std::string message) const;

  const ParameterScope& parameters_;
  Report& report_;
  int scope_;
};

/// Is this how YAML or C writes a number that is not finite (.inf, -nan, 1e999)?
bool means_not_finite(const std::string& text);

/// Checks that a dimension is the demanded one; a bare number always is. Says what is wrong otherwise.
std::string unit_complaint(const std::optional<Dimension>& written, const std::optional<Dimension>& demanded);

}  // namespace stepwire
