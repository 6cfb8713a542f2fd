#pragma once

#include "tests/random/making.hpp"

namespace stepwire::random {

/// Prepares a block whose sizes or inputs its declaration leaves open.
void prepare(Making& making);
/// Number of elements that a list of inputs gets.
std::size_t list_count(Making& making, const InputSpec& input);
/// The source of an input that needs signals of one kind: away from 0, within a range, a turn; nullopt for
/// all others.
std::optional<Wire> special_wire(Making& making, const InputSpec& input, const Shape& shape);
/// True for an input of which special_wire() has a source.
bool has_special_wire(const Making& making, const InputSpec& input);
/// A parameter's value; empty if it is left out.
std::string value_of(Making& making, const ParameterSpec& spec);
/// False for a parameter that is left out unless it is required.
bool may_be_given(const Making& making, const ParameterSpec& spec);

/// Parameters whose value does not follow from their declaration, by "Type.parameter".
using SpecialValue = std::string (*)(Making& making);
const std::map<std::string, SpecialValue>& special_values();
/// A matrix with this on its diagonal and smaller numbers beside it.
std::string matrix_text(Making& making, Index rows, Index columns, double lower, double upper, double beside);

}  // namespace stepwire::random
