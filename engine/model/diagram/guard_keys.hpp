#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/yaml/section.hpp"
#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

/// The keys that a part, and a block, may have beside its own, to run on condition: `enable`, `trigger`, and
/// `guard`, by which a flattened file names the Guard itself.
const std::vector<yaml::Key>& guard_keys();
bool is_guard_key(std::string_view key);
/// Is it a condition also where the block or part has a key of this name itself? `trigger: {when: index}`
/// beside the `trigger: rising` of a reset.
bool is_condition(std::string_view key, const yaml::Node& value);

/// What stands at `enable` or `trigger`: a condition, or {when: condition, states: reset, outputs: held}.
struct GuardOptions {
  const yaml::Node* when = nullptr;
  std::optional<int> edge, states;      ///< Guard::Edge, Guard::States
  const yaml::Node* outputs = nullptr;  ///< `reset`, or a value; null where they are held
};

/// The names in a condition as it is written: of its signals, and of the parameters that it names bare.
std::vector<std::string> signals_of_condition(const yaml::Node& condition);
/// Is it a formula, and neither the name of a signal ("door", "rig.force.2") nor a number or parameter?
bool is_formula(const yaml::Node& condition);
/// A formula without the '=' before it, and without the '$' before names of parameters.
std::string plain_formula(std::string text);

/// `owner` is the part or block that has the key.
GuardOptions read_guard_options(const yaml::Node& node, const std::string& key, const Scope& scope,
                                const std::string& owner, Report& report);

}  // namespace stepwire::diagram
