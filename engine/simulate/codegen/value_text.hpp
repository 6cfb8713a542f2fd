#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/diagram/bindings.hpp"
#include "engine/model/diagram/diagram.hpp"

namespace stepwire::codegen {

/// Number of a value in a file, as C++.
struct NumberText {
  std::string text;
  std::optional<double> constant;  ///< set if it depends on no parameter
  bool computed = false;           ///< true for the result of an expression, which may be non-finite
};

/// Writes values of a file that depend on parameters as C++, with the bits of ValueReader.
class ValueTexts {
 public:
  /// Function that returns the C++ name of a parameter (an index in Diagram::parameters) without its element;
  /// an empty text for a fixed one.
  using Name = std::function<std::string(std::size_t d)>;

  ValueTexts(const diagram::Diagram& diagram, Name name) : diagram_(diagram), name_(std::move(name)) {}

  /// Returns the numbers of a value: one, those of a list, or those of a matrix column by column. Returns
  /// std::nullopt if the text holds anything else, or applies a unit to a value that depends on a parameter.
  /// The scope is that of the file whose parameters it names.
  std::optional<std::vector<NumberText>> numbers(const yaml::Node& node, int scope) const;
  /// Returns the numbers of a parameter.
  std::vector<NumberText> parameter(std::size_t d) const;

 private:
  using Numbers = std::optional<std::vector<NumberText>>;

  Numbers with_unit(const yaml::Node& node, int scope) const;
  Numbers list(const yaml::Node& node, int scope) const;
  Numbers rows(const yaml::Node& node, int scope) const;
  Numbers scalar(const yaml::Node& node, int scope) const;
  Numbers expression(const std::string& text, int scope) const;
  Numbers of_matrices(std::string text, int scope) const;
  /// Returns the numbers of a parameter of a file by its name there.
  Numbers named(const std::string& name, int scope) const;

  const diagram::Diagram& diagram_;
  Name name_;
};

/// Returns the numbers of a value, those of a matrix column by column; an empty list for anything else.
std::vector<double> numbers_of(const Value& value);

/// Returns the C++ expression of element k of a value: "x" for a number, "x[2]" for a list, "x[1][0]" for a
/// matrix.
std::string element_text(const std::string& name, const Value& value, std::size_t k);

}  // namespace stepwire::codegen
