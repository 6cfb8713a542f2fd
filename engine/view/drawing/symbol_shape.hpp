#pragma once

#include <string>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::drawing {

/// Returns the name of an outline in draw.mjs.
inline const char* outline_name(Symbol::Outline outline) {
  switch (outline) {
    case Symbol::Outline::triangle:
      return "triangle";
    case Symbol::Outline::circle:
      return "circle";
    case Symbol::Outline::bar:
      return "bar";
    default:
      return "box";
  }
}

/// Returns the signs of the inputs in a parameter such as "+-".
inline std::string signs_of(const diagram::DiagramBlock& block) {
  const ParameterSpec* parameter = block.type().parameter(block.type().symbol.signs);
  if (!parameter) return {};
  const Value value = parameter->get(block.block.get());
  return value.text() ? *value.text() : "";
}

}  // namespace stepwire::drawing
