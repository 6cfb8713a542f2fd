#pragma once

#include <map>
#include <string>

#include "engine/model/diagram/scope.hpp"
#include "engine/model/diagram/settings.hpp"

namespace stepwire::diagram {

/// Values of a part's parameters given by the using file, and the scope for reading them.
struct Overrides {
  const Scope* from = nullptr;
  std::map<std::string, const yaml::Node*> values;
};

/// Evaluates `parameters:` of a scope in the order of their dependences, with the replacements by the using
/// file and `--set`. Defines them in the scope and lists them in the Diagram.
void define_parameters(Scope& scope, const Overrides& overrides, Settings& settings, Report& report);

}  // namespace stepwire::diagram
