#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/yaml/section.hpp"
#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

/// Returns the keys by which a part or block runs on a condition: `enable`, `trigger`, and `guard`, by which
/// a flattened file names the Guard itself.
const std::vector<yaml::Key>& guard_keys();
bool is_guard_key(std::string_view key);
/// True where the key is a condition although the block or part has a key of this name itself: `trigger:
/// {when: index}` beside the `trigger: rising` of a reset.
bool is_condition(std::string_view key, const yaml::Node& value);

/// Value of `enable` or `trigger`: a condition, or {when: condition, states: reset, outputs: held}.
struct GuardOptions {
  const yaml::Node* when = nullptr;
  std::optional<int> edge, states;      ///< Guard::Edge, Guard::States
  const yaml::Node* outputs = nullptr;  ///< `reset`, or a value; nullptr if outputs are held
};

/// Returns the names in a condition, both of signals and of parameters without '$'.
std::vector<std::string> signals_of_condition(const yaml::Node& condition);
/// True for a formula; false for the name of a signal ("door", "rig.force.2"), a number or a parameter.
bool is_formula(const yaml::Node& condition);
/// Returns a formula without its leading '=', and without '$' before names of parameters.
std::string plain_formula(std::string text);

/// Reads the value of such a key; `owner` is the part or block that has it.
GuardOptions read_guard_options(const yaml::Node& node, const std::string& key, const Scope& scope,
                                const std::string& owner, Report& report);

}  // namespace stepwire::diagram
