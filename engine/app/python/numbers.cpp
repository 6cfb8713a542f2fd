#include "engine/app/python/numbers.hpp"

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "engine/base/text/characters.hpp"
#include "engine/base/unit/unit.hpp"

namespace stepwire::python {

namespace py = pybind11;

_object* numbers_of(std::span<const double> numbers, std::size_t columns) {
  if (numbers.size() == 1) return PyFloat_FromDouble(numbers[0]);
  if (columns > 1) {
    const std::array<std::size_t, 2> shape{numbers.size() / columns, columns};
    return py::array_t<double, py::array::f_style>(shape, numbers.data()).release().ptr();
  }
  return py::array_t<double>(static_cast<py::ssize_t>(numbers.size()), numbers.data()).release().ptr();
}

namespace {

/// Cuts the number behind the last dot off a name, and returns it as an index from 0.
std::optional<std::size_t> cut_index(std::string_view& name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return std::nullopt;
  std::size_t number = 0;
  const char* const end = name.data() + name.size();
  const auto [rest, error] = std::from_chars(name.data() + dot + 1, end, number);
  if (error != std::errc{} || rest != end || number == 0) return std::nullopt;
  name = name.substr(0, dot);
  return number - 1;
}

const SignalInfo* find_array(const Model& model, std::string_view name, bool is_matrix) {
  const auto& all = model.signals();
  const auto found = std::ranges::find(all, name, &SignalInfo::name);
  return found != all.end() && found->size > 1 && (found->columns > 1) == is_matrix ? &*found : nullptr;
}

}  // namespace

NamedSignal find_signal(const Model& model, const std::string& name) {
  const auto& all = model.signals();
  if (std::ranges::find(all, name, &SignalInfo::name) != all.end()) return {model.signal(name), std::nullopt};
  std::string_view base = name;
  const auto last = cut_index(base);
  const SignalInfo* const vector = last ? find_array(model, base, false) : nullptr;
  if (vector && *last < vector->size) return {model.signal(vector->name), last};
  const auto row = last ? cut_index(base) : std::nullopt;
  const SignalInfo* const matrix = row ? find_array(model, base, true) : nullptr;
  if (!matrix) return {model.signal(name), std::nullopt};  // throws
  const std::size_t rows = matrix->size / matrix->columns;
  if (*row >= rows || *last >= matrix->columns) return {model.signal(name), std::nullopt};  // throws
  return {model.signal(matrix->name), *row + *last * rows};
}

_object* numbers_of(const Model& model, const NamedSignal& signal, std::span<const double> numbers) {
  if (signal.element) return PyFloat_FromDouble(numbers[*signal.element]);
  return numbers_of(numbers, model.signals()[signal.id.index].columns);
}

_object* object_of(const Value& value) {
  if (const auto* number = std::get_if<double>(&value.content)) return PyFloat_FromDouble(*number);
  if (const auto* flag = std::get_if<bool>(&value.content)) return py::bool_(*flag).release().ptr();
  if (const auto* text = value.text()) return py::str(*text).release().ptr();
  if (const auto* list = std::get_if<Eigen::VectorXd>(&value.content))
    return py::array_t<double>(list->size(), list->data()).release().ptr();
  const auto* matrix = std::get_if<Eigen::MatrixXd>(&value.content);
  if (!matrix) return py::none().release().ptr();
  return py::array_t<double, py::array::f_style>({matrix->rows(), matrix->cols()}, matrix->data())
      .release()
      .ptr();
}

namespace {

/// Returns the SI value of a number or of a text such as "3 mm".
double number_in(py::handle value, const std::string& name, const std::string& unit) {
  if (!PyUnicode_Check(value.ptr())) return value.cast<double>();
  const std::string text = value.cast<std::string>();
  const auto quantity = unit::parse_quantity(text);
  const auto own = unit::parse_unit(unit);
  const bool fits =
      unit.empty() || !quantity || !quantity->dimension || (own && *quantity->dimension == own->dimension);
  if (quantity && fits) return quantity->value;
  throw py::value_error(fmt::format("{} takes numbers{}, not '{}'", name, unit.empty() ? "" : " in " + unit,
                                    text::visible(text)));
}

bool has_texts(py::handle value) {
  if (!PyList_Check(value.ptr()) && !PyTuple_Check(value.ptr())) return false;
  for (const py::handle item : py::reinterpret_borrow<py::sequence>(value))
    if (PyUnicode_Check(item.ptr())) return true;
  return false;
}

py::type_error wrong_kind(const InputInfo& input) {
  if (input.columns == 1)
    return py::type_error(input.name +
                          " takes numbers: one, a list or an array in SI, or texts with their unit");
  return py::type_error(
      fmt::format("{} takes an array ({}, {}) in SI", input.name, input.size / input.columns, input.columns));
}

std::vector<double> read_matrix(py::handle value, const InputInfo& input) {
  const auto array = py::array_t<double, py::array::f_style | py::array::forcecast>::ensure(value);
  const auto columns = static_cast<py::ssize_t>(input.columns);
  if (!array || array.ndim() != 2 || array.shape(1) != columns ||
      array.size() != static_cast<py::ssize_t>(input.size))
    throw wrong_kind(input);
  return {array.data(), array.data() + array.size()};
}

std::vector<double> read_numbers(py::handle of, const InputInfo& input) {
  PyObject* const value = of.ptr();
  if (input.columns > 1) return read_matrix(of, input);
  if (PyFloat_CheckExact(value)) return {PyFloat_AS_DOUBLE(value)};
  if (PyUnicode_Check(value)) return {number_in(value, input.name, input.unit)};
  if (has_texts(value)) {
    std::vector<double> numbers;
    for (const py::handle item : py::reinterpret_borrow<py::sequence>(value))
      numbers.push_back(number_in(item, input.name, input.unit));
    return numbers;
  }
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(value);
  if (!array || array.ndim() > 1) throw wrong_kind(input);
  return {array.data(), array.data() + array.size()};
}

}  // namespace

std::vector<double> numbers_in(_object* value, const InputInfo& input) {
  std::vector<double> numbers = read_numbers(value, input);
  const auto is_finite = [](double number) { return std::isfinite(number); };
  const auto wrong = std::ranges::find_if_not(numbers, is_finite);
  if (wrong == numbers.end()) return numbers;
  throw py::value_error(numbers.size() == 1 ? fmt::format("{} takes a number, not {}", input.name, *wrong)
                                            : fmt::format("{} takes numbers, and element {} is {}",
                                                          input.name, wrong - numbers.begin() + 1, *wrong));
}

yaml::Node node_of(_object* value) {
  const py::handle of(value);
  yaml::Node node;
  if (py::isinstance<py::dict>(of)) {
    node.kind = yaml::Node::Kind::map;
    for (const auto& [key, item] : py::reinterpret_borrow<py::dict>(of))
      node.entries.push_back({py::cast<std::string>(key), {}, node_of(item.ptr())});
  } else if (py::isinstance<py::list>(of)) {
    node.kind = yaml::Node::Kind::list;
    for (const py::handle item : of) node.items.push_back(node_of(item.ptr()));
  } else {
    node.kind = yaml::Node::Kind::scalar;
    node.text = py::cast<std::string>(of);
  }
  return node;
}

}  // namespace stepwire::python
