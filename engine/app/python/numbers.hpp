#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/base/yaml/document.hpp"
#include "engine/model/block/value.hpp"
#include "engine/stepwire/model.hpp"

struct _object;

namespace stepwire::python {

/// Returns a new reference: a float for one number, an array (n,), or (rows, columns) for a matrix in
/// column-major order. The caller must hold the interpreter lock.
_object* numbers_of(std::span<const double> numbers, std::size_t columns = 1);

/// A signal, or one of its elements.
struct NamedSignal {
  SignalId id;
  std::optional<std::size_t> element;  ///< index of its number
};

/// Finds a signal by its name in `record` or, as the columns of a run, by that of an element: "x.2" of a
/// vector, "R.1.2" of a matrix. Throws Error for other names.
NamedSignal find_signal(const Model& model, const std::string& name);

/// Returns a new reference to the numbers of the signal, or to the float of the element.
_object* numbers_of(const Model& model, const NamedSignal& signal, std::span<const double> numbers);

/// Returns a parameter value as float, bool, text, or array (n,) or (rows, columns); None for a tree.
_object* object_of(const Value& value);

/// Converts a number, a list or an array in SI, or texts with units such as "3 mm". A text must match the
/// unit of the input, unless that is unknown. A matrix must have the shape (rows, columns).
/// Throws TypeError and ValueError of Python, the latter also for NaN and infinity.
std::vector<double> numbers_in(_object* value, const InputInfo& input);

/// Converts a dictionary of dictionaries, lists and texts to the tree that YAML text would give.
yaml::Node node_of(_object* value);

}  // namespace stepwire::python
