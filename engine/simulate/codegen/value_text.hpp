#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/diagram/bindings.hpp"
#include "engine/model/diagram/diagram.hpp"

namespace stepwire::codegen {

/// A number of a value of a file, as C++.
struct NumberText {
  std::string text;
  std::optional<double> constant;  ///< where it follows from no parameter
  bool computed = false;           ///< by an expression, whose result may not be finite
};

/// Writes values of a file that follow from parameters as C++ with the bits that ValueReader reads.
class ValueTexts {
 public:
  /// What parameter d (an index in Diagram::parameters) is called, without its element; empty where it keeps
  /// its value.
  using Name = std::function<std::string(std::size_t d)>;

  ValueTexts(const diagram::Diagram& diagram, Name name) : diagram_(diagram), name_(std::move(name)) {}

  /// The numbers of a value: one, those of a list, or those of a matrix column by column. Nothing where the
  /// text holds anything else, or applies a unit to what follows from a parameter. `scope` is that of the
  /// file whose parameters it names.
  std::optional<std::vector<NumberText>> numbers(const yaml::Node& node, int scope) const;
  /// The numbers of a parameter.
  std::vector<NumberText> parameter(std::size_t d) const;

 private:
  using Numbers = std::optional<std::vector<NumberText>>;

  Numbers with_unit(const yaml::Node& node, int scope) const;
  Numbers list(const yaml::Node& node, int scope) const;
  Numbers rows(const yaml::Node& node, int scope) const;
  Numbers scalar(const yaml::Node& node, int scope) const;
  Numbers expression(const std::string& text, int scope) const;
  Numbers of_matrices(std::string text, int scope) const;
  /// The numbers of a parameter of a file by its name there.
  Numbers named(const std::string& name, int scope) const;

  const diagram::Diagram& diagram_;
  Name name_;
};

/// The numbers of a value, those of a matrix column by column; none of anything else.
std::vector<double> numbers_of(const Value& value);

/// "x" for a single number, "x[2]" of a list, "x[1][0]" of a matrix: C++ for element k of a value.
std::string element_text(const std::string& name, const Value& value, std::size_t k);

}  // namespace stepwire::codegen
