#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/model/block/block_type.hpp"
#include "engine/model/diagram/parameters.hpp"

namespace stepwire::diagram {

/// Returns the names that a block's formulas may use: those in its lists of words, and in its maps without
/// formulas.
std::vector<std::string> words_given_to(const BlockType& type, const yaml::Node& keys);

/// Returns an expression with '$' before each name that is only a parameter: `k*u1` becomes `$k*u1`, which is
/// filled in later. Invalid expressions are returned unchanged.
std::string name_parameters(const std::string& text, const ParameterScope& parameters,
                            const std::function<bool(const std::string& name)>& has_meaning);
/// Does the same for the expressions in a parameter of a block, selected by their keys in a tree. Names of
/// the block's inputs and the given words keep their meaning.
yaml::Node name_parameters(const yaml::Node& node, const std::vector<std::string>& keys,
                           const BlockType& type, const std::vector<std::string>& words,
                           const ParameterScope& parameters);

}  // namespace stepwire::diagram
