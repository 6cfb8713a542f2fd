#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/base/yaml/document.hpp"
#include "engine/model/block/value.hpp"
#include "engine/stepwire/model.hpp"

struct _object;

namespace stepwire::python {

/// A float for one number, else a new array (n,), or (rows, columns) of a matrix whose numbers are column by
/// column: a new reference. The lock is held.
_object* numbers_of(std::span<const double> numbers, std::size_t columns = 1);

/// A value of a parameter: a float, a bool, a text, an array (n,) or (rows, columns); None for a tree.
_object* object_of(const Value& value);

/// The numbers of a number, a list or an array, SI; of a text, or a list with texts, in its unit: "3 mm". `unit`
/// is that of what takes them, empty where it is not known; a matrix has an array (rows, columns). Throws
/// TypeError and ValueError of Python's, also for NaN.
std::vector<double> numbers_in(_object* value, const InputInfo& input);

/// The tree of a dictionary whose values are dictionaries, lists and texts, as a file would have it.
yaml::Node node_of(_object* value);

}  // namespace stepwire::python
