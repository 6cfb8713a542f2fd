#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/app/simulink/value.hpp"

namespace stepwire::simulink {

/// True for a function that called() evaluates with this number of arguments; constants such as pi have none.
bool is_function(const std::string& name, std::size_t arguments);
/// Returns the value of a function. Throws ValueError for arguments that do not fit.
Value called(const std::string& name, const std::vector<Value>& arguments);
/// Returns an element of a variable: A(2), A(2, 3), counted from 1. Throws ValueError beyond its size.
Value indexed(const Value& value, const std::vector<Value>& indices);
/// Returns [a, b]. Throws ValueError for different numbers of rows.
Value beside(const Value& a, const Value& b);
/// Returns [a; b; ...]. Throws ValueError for different numbers of columns.
Value stacked(const std::vector<Value>& rows);

}  // namespace stepwire::simulink
