#pragma once

#include <string>
#include <vector>

#include "engine/model/block/block_type.hpp"
#include "engine/model/diagram/unit_expression.hpp"

namespace stepwire::diagram {

/// Declared units of one kind of block, read once; its unit variables are numbered from 0.
struct TypeUnits {
  std::vector<UnitExpression> parameters, inputs, outputs, states;
  std::vector<std::string> variables;

  explicit TypeUnits(const BlockType& type);
};

}  // namespace stepwire::diagram
