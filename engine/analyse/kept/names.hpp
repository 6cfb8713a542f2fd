#pragma once

#include <string>

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/simulate/run/run.hpp"

namespace stepwire::kept {

/// Returns the names that figures and claims of a job may use, except those of its analyses and its scene.
query::SymbolTable names_of(const run::Job& job);

/// Returns a swept word without the quotes of the file.
std::string without_quotes(const std::string& word);

}  // namespace stepwire::kept
