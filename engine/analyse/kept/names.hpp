#pragma once

#include <string>

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/simulate/run/run.hpp"

namespace stepwire::kept {

/// What figures and claims of a job may name, but for what its analyses and its scene add.
query::SymbolTable names_of(const run::Job& job);

/// A swept word as it is meant, without the quotes of its file.
std::string without_quotes(const std::string& word);

}  // namespace stepwire::kept
