#pragma once

#include <string>
#include <utility>

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/base/expression/expression.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::query {

/// An ExpressionError that may carry the word that was probably meant.
struct FormulaError : expression::ExpressionError {
  FormulaError(yaml::Message message, std::size_t position)
      : expression::ExpressionError(message.text(), position), message(std::move(message)) {}
  yaml::Message message;
};

/// What is wrong with a name behind '$', and with one of a signal, that mean nothing.
yaml::Message unknown_parameter(const std::string& name, const SymbolTable& names);
yaml::Message unknown_column(const std::string& name, const SymbolTable& names);

}  // namespace stepwire::query
