#pragma once

#include <string>
#include <utility>

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/base/expression/expression.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::query {

/// ExpressionError whose message may suggest a correct word.
struct FormulaError : expression::ExpressionError {
  FormulaError(yaml::Message message, std::size_t position)
      : expression::ExpressionError(message.text(), position), message(std::move(message)) {}
  yaml::Message message;
};

/// Return the message for an unknown name: after '$', and of a signal.
yaml::Message unknown_parameter(const std::string& name, const SymbolTable& names);
yaml::Message unknown_column(const std::string& name, const SymbolTable& names);

}  // namespace stepwire::query
