#pragma once

#include <string>

#include "engine/analyse/query/symbol_table.hpp"
#include "engine/simulate/run/run.hpp"

namespace stepwire::kept {

/// Returns the names that figures and claims of a job may use, except those of its analyses and its scene.
/// Parameters that the sweep varies, and those that follow from them, are marked.
query::SymbolTable names_of(const run::Job& job);

/// Returns these names without marks, for a sweep whose axes the diagram need not have.
query::SymbolTable names_of_file(const run::Job& job);

/// Returns a swept word without the quotes of the file.
std::string without_quotes(const std::string& word);

}  // namespace stepwire::kept
