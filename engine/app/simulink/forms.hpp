#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/app/simulink/block_writer.hpp"

namespace stepwire::simulink {

// Forms that several translations share.

/// Makes the node of a further block.
yaml::Node block_node(const std::string& type, std::vector<std::pair<std::string, yaml::Node>> keys);
/// Makes the block an Expression of its inputs: u1, u2, ...
BlockWriter& expression(BlockWriter& write, const std::string& formula, std::vector<yaml::Node> inputs);
/// Returns the source of a value: the number itself, or a Constant beside the block for a vector or formula.
yaml::Node constant_source(BlockWriter& write, const std::string& suffix, const Value& value);
/// Returns a number as it is written in a formula, in brackets where it is one.
std::string in_formula(const Cell& cell);
/// Returns the quotient of a value and a number.
Value divided(const Value& value, double by);
/// Returns the input of an integrator for its initial value; 0 where that is a parameter.
int initial_input(const Model& model, const Block& integrator);
/// Adds the reset, the initial value and the limits of an integrator.
void add_integrator_keys(BlockWriter& write);
/// Adds `reset`, `trigger` for the ExternalReset of a block, whose signal is at an input.
void add_reset(BlockWriter& write, const std::string& kind, int input);
/// Throws Untranslated where a parameter has another value than this one.
void require(const BlockWriter& write, const std::string& name, const std::string& only);
/// Pads a polynomial with zeros at the end, or at the start, to a number of coefficients.
Value padded(const Value& polynomial, std::size_t count, bool at_end);
/// True for a source that is 0 or 1 everywhere.
bool is_truth(FlatModel& model, const std::string& source);

}  // namespace stepwire::simulink
