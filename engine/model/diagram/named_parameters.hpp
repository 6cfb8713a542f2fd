#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/model/block/block_type.hpp"
#include "engine/model/diagram/parameters.hpp"

namespace stepwire::diagram {

/// What lists of words, and maps without formulas, of a block hold: names that its formulas may use.
std::vector<std::string> words_given_to(const BlockType& type, const yaml::Node& keys);

/// An expression with a '$' before each name that is a parameter and nothing else: `k*u1` becomes `$k*u1`,
/// which is filled in. What cannot be read is left as it is.
std::string name_parameters(const std::string& text, const ParameterScope& parameters,
                            const std::function<bool(const std::string& name)>& has_meaning);
/// The same for the texts of a block's parameter that are expressions, by their keys in a tree; names of the
/// block's inputs, and the words that it is given, have the meaning that it gives them.
yaml::Node name_parameters(const yaml::Node& node, const std::vector<std::string>& keys,
                           const BlockType& type, const std::vector<std::string>& words,
                           const ParameterScope& parameters);

}  // namespace stepwire::diagram
