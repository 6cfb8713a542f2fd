#pragma once

#include <string>
#include <vector>

#include "engine/model/block/block_type.hpp"
#include "engine/model/diagram/unit_equations.hpp"
#include "engine/model/diagram/unit_expression.hpp"

namespace stepwire::diagram {

/// True for a list whose elements are joined to one vector.
bool joins_pieces(const InputSpec& spec);

/// Declared units of one kind of block, parsed once; its unit variables are numbered from 0. An output
/// declared as a product has a variable of its own, whose unit may follow from the inputs that read it.
struct TypeUnits {
  struct Product {
    std::size_t output = 0;
    UnitExpression unit;
  };
  std::vector<UnitExpression> parameters, inputs, outputs, states;
  std::vector<Product> products;
  std::vector<std::string> variables;
  std::vector<Elements> elements;  ///< of the variables
  /// True for a factor of an output that is the unit of no input by itself.
  bool is_factor(const std::string& variable) const;
  /// True for the variable of a product.
  static bool is_of_product(const std::string& variable) { return variable.starts_with('='); }

  explicit TypeUnits(const BlockType& type);

 private:
  void take_products();
  Elements elements_of(const std::string& variable, const BlockType& type) const;
  bool is_scaled(const std::string& variable) const;
};

}  // namespace stepwire::diagram
