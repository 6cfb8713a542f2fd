#pragma once

#include <map>
#include <string>

#include "engine/model/plan/plan.hpp"

namespace stepwire::plan {

/// Calls configure() of a block and returns its answers. `block` is the block at this index, or another one
/// with the same connections. A refused parameter adds a fault. Throws EnvironmentError where a file of the
/// data folder is missing. `constants` replaces constants wired to its inputs, by input name.
Configuration configure(const Plan& plan, std::size_t index, void* block, yaml::Faults& faults,
                        const std::map<std::string, double>& constants = {});

/// Repeats the single number of a parameter for every element.
void spread(AnyBlock& block, const ParameterSpec& spec, Eigen::Index size);

/// Calls prepare() of a block, which derives members from its parameters, sizes and period.
void prepare(const Plan& plan, std::size_t index, void* block);

}  // namespace stepwire::plan
