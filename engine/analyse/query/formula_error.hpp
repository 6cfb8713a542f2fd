#pragma once

#include <utility>

#include "engine/base/expression/expression.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::query {

/// An ExpressionError that may carry the word that was probably meant.
struct FormulaError : expression::ExpressionError {
  FormulaError(yaml::Message message, std::size_t position)
      : expression::ExpressionError(message.text(), position), message(std::move(message)) {}
  yaml::Message message;
};

}  // namespace stepwire::query
