#pragma once

#include <map>
#include <string>

#include "engine/model/diagram/scope.hpp"
#include "engine/model/diagram/settings.hpp"

namespace stepwire::diagram {

/// What the using file gives to a part's parameters: the node and how that file reads it.
struct Overrides {
  const Scope* from = nullptr;
  std::map<std::string, const yaml::Node*> values;
};

/// Evaluates `parameters:` of a scope in the order of their dependence, with what the using file and `--set`
/// put in their place, defines them in the scope and lists them in the Diagram.
void define_parameters(Scope& scope, const Overrides& overrides, Settings& settings, Report& report);

}  // namespace stepwire::diagram
