#pragma once

#include <string>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::drawing {

/// What draw.mjs calls an outline.
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

/// A sign for each input that a parameter such as "+-" holds.
inline std::string signs_of(const diagram::DiagramBlock& block) {
  const ParameterSpec* parameter = block.type().parameter(block.type().symbol.signs);
  if (!parameter) return {};
  const Value value = parameter->get(block.block.get());
  return value.text() ? *value.text() : "";
}

}  // namespace stepwire::drawing
