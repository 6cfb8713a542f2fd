#pragma once

#include <map>
#include <string>

#include "engine/model/plan/plan.hpp"

namespace stepwire::plan {

/// Lets a block of a plan check its parameters and answer what its declaration leaves open; `block` is the
/// one of this index, or another with the same connections. A parameter that it refuses is a fault. Throws
/// EnvironmentError where a file of the data folder is missing. `constants` replaces numbers that are wired
/// to its inputs, by the names of these.
Configuration configure(const Plan& plan, std::size_t index, void* block, yaml::Faults& faults,
                        const std::map<std::string, double>& constants = {});

/// Repeats the one number of a parameter for every element.
void spread(AnyBlock& block, const ParameterSpec& spec, Eigen::Index size);

/// Lets a block compute what follows from its parameters, sizes and period.
void prepare(const Plan& plan, std::size_t index, void* block);

}  // namespace stepwire::plan
