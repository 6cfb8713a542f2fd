#include "engine/app/python/python_class.hpp"

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "engine/app/python/lock.hpp"
#include "engine/app/python/numbers.hpp"
#include "engine/base/unit/unit.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire::python {

namespace {

using All = std::make_index_sequence<PythonBlock::most>;

PythonBlock& block_of(void* block) {
  return *static_cast<PythonBlock*>(block);
}

template <std::size_t... k>
constexpr auto input_binders(std::index_sequence<k...>) {
  return std::array<decltype(InputSpec::bind), sizeof...(k)>{
      [](void* block, const double* data, Eigen::Index size) {
        block_of(block).inputs[k].bind(data, size);
      }...};
}

template <std::size_t... k>
constexpr auto output_binders(std::index_sequence<k...>) {
  return std::array<decltype(OutputSpec::bind), sizeof...(k)>{
      [](void* block, double* data, Eigen::Index size) { block_of(block).results[k].bind(data, size); }...};
}

template <std::size_t... k>
constexpr auto state_binders(std::index_sequence<k...>) {
  return std::array<decltype(StateSpec::bind), sizeof...(k)>{
      [](void* block, double* data, double* derivative, Eigen::Index size) {
        block_of(block).states[k].bind(data, size);
        block_of(block).states[k].derivative.bind(derivative, size);
      }...};
}

template <std::size_t... k>
constexpr auto memory_binders(std::index_sequence<k...>) {
  return std::array<decltype(StateSpec::bind), sizeof...(k)>{
      [](void* block, double* data, double*, Eigen::Index size) {
        block_of(block).memory[k].bind(data, size);
      }...};
}

template <std::size_t... k>
constexpr auto setters(std::index_sequence<k...>) {
  return std::array<decltype(ParameterSpec::set), sizeof...(k)>{
      [](void* block, const Value& value) { block_of(block).values[k] = value; }...};
}

template <std::size_t... k>
constexpr auto getters(std::index_sequence<k...>) {
  return std::array<decltype(ParameterSpec::get), sizeof...(k)>{
      [](const void* block) { return static_cast<const PythonBlock*>(block)->values[k]; }...};
}

void require_few(const std::string& name, std::size_t count, const char* what) {
  if (count > PythonBlock::most)
    throw std::invalid_argument(
        fmt::format("{} has {} {}; a block has {} at most", name, count, what, PythonBlock::most));
}

void require_unit(const std::string& subject, const std::string& unit) {
  if (unit == "*" || unit.find('\'') != unit.npos || unit::parse_unit(unit)) return;
  throw std::invalid_argument(
      fmt::format("{}: '{}' is no unit; write e.g. N, m/s, or 1 for none", subject, unit));
}

void require_units(const PythonClass& of) {
  for (const auto* ports : {&of.inputs, &of.outputs, &of.states, &of.memory})
    for (const PythonClass::Port& port : *ports) require_unit(of.name + "." + port.name, port.unit);
  for (const PythonClass::Parameter& parameter : of.parameters)
    require_unit(of.name + "." + parameter.name, parameter.unit);
}

ParameterKind kind_of(const Value& value) {
  if (value.text()) return ParameterKind::text;
  if (std::holds_alternative<bool>(value.content)) return ParameterKind::flag;
  return std::holds_alternative<Eigen::VectorXd>(value.content) ? ParameterKind::vector
                                                                : ParameterKind::number;
}

void add_parameters(BlockType& type, const PythonClass& of) {
  static constexpr auto set = setters(All());
  static constexpr auto get = getters(All());
  for (std::size_t i = 0; i < of.parameters.size(); ++i) {
    const PythonClass::Parameter& parameter = of.parameters[i];
    ParameterSpec spec{parameter.name, kind_of(parameter.value), parameter.unit, "", parameter.doc, {}, {}};
    spec.required = parameter.required;
    spec.set = set[i];
    spec.get = get[i];
    type.parameters.push_back(std::move(spec));
  }
}

void add_ports(BlockType& type, const PythonClass& of) {
  static constexpr auto bind_input = input_binders(All());
  static constexpr auto bind_output = output_binders(All());
  for (std::size_t i = 0; i < of.inputs.size(); ++i) {
    const PythonClass::Port& port = of.inputs[i];
    InputSpec spec{port.name, port.unit, port.shape, "", fmt::format("inputs[{}]", i), port.feedthrough};
    spec.bind = bind_input[i];
    spec.unbind = [](void*) {};
    type.inputs.push_back(std::move(spec));
  }
  for (std::size_t i = 0; i < of.outputs.size(); ++i)
    type.outputs.push_back({of.outputs[i].name, of.outputs[i].unit, of.outputs[i].shape, "",
                            fmt::format("results[{}]", i), "", bind_output[i]});
}

void add_states(BlockType& type, const PythonClass& of) {
  static constexpr auto bind_state = state_binders(All());
  static constexpr auto bind_memory = memory_binders(All());
  const auto add = [&](const PythonClass::Port& port, bool continuous, std::size_t i) {
    const std::string member = fmt::format("{}[{}]", continuous ? "states" : "memory", i);
    StateSpec spec{port.name, port.unit, port.shape, "", member, continuous, true, port.initial};
    spec.bind = continuous ? bind_state[i] : bind_memory[i];
    type.states.push_back(std::move(spec));
  };
  for (std::size_t i = 0; i < of.states.size(); ++i) add(of.states[i], true, i);
  for (std::size_t i = 0; i < of.memory.size(); ++i) add(of.memory[i], false, i);
}

bool takes(const Method& method, Source source) {
  for (const Argument& argument : method.arguments)
    if (argument.source == source) return true;
  return false;
}

bool takes(const PythonClass& of, Source source) {
  return takes(of.output_method, source) || takes(of.slope_method, source) || takes(of.update_method, source);
}

Timing timing_of(const PythonClass& of) {
  if (!of.states.empty() || takes(of.output_method, Source::time)) return Timing::continuous;
  return of.update_method.exists ? Timing::discrete : Timing::inherited;
}

void leave_out(BlockType& type, const PythonClass& of) {
  if (!of.output_method.exists) type.run_outputs = {};
  if (!of.slope_method.exists) type.run_derivatives = {};
  if (!of.update_method.exists) type.run_update = {};
  // A clock with a period is refused for blocks without one, for example behind a trigger. So the clock is
  // dropped if no method uses the period.
  if (!takes(of, Source::period))
    std::erase_if(type.clocks, [](const ClockSpec& clock) { return clock.bind_period; });
}

void require_fit(const PythonClass& of) {
  require_few(of.name, of.inputs.size(), "inputs");
  require_few(of.name, of.outputs.size(), "outputs");
  require_few(of.name, std::max(of.states.size(), of.memory.size()), "states");
  require_few(of.name, of.parameters.size(), "parameters");
  require_units(of);
}

/// Returns the block type without ports, states and parameters.
BlockType bare_type(const PythonClass& of) {
  Declare<PythonBlock> is;
  PythonBlock::declare(is);
  BlockType type = is.take();
  type.name = of.name;
  type.doc = of.doc;
  type.declared_at = of.place;
  type.folder = "python";
  type.header.clear();
  type.timing = timing_of(of);
  type.not_generated = "its methods are Python's; a block of C++ can be generated";
  return type;
}

}  // namespace

BlockType type_of(std::shared_ptr<const PythonClass> made) {
  require_fit(*made);
  BlockType type = bare_type(*made);
  add_parameters(type, *made);
  add_ports(type, *made);
  add_states(type, *made);
  leave_out(type, *made);
  type.construct = [made](void* memory) {
    auto* block = ::new (memory) PythonBlock;
    block->of = made;
    for (std::size_t i = 0; i < made->parameters.size(); ++i) block->values[i] = made->parameters[i].value;
  };
  return type;
}

namespace py = pybind11;

/// Destination of a result of a method.
struct Target {
  double* numbers;
  Eigen::Index size;
  const char* name;
  Eigen::Index rows = 0;  ///< rows of a matrix in column-major order; 0 for a vector
};

/// Source of an argument of a method.
struct Given {
  const double* numbers;
  Eigen::Index size;
  Eigen::Index rows = 0;  ///< as in Target
};

/// Python object of a block, with the methods that a run calls.
/// The caller must hold the interpreter lock. Calls that raise a Python exception return false or nullptr.
class Instance {
 public:
  /// Makes the object. Its parameters are set as attributes before __init__ is called.
  static std::shared_ptr<Instance> make(const PythonClass& of, const Value* parameters);

  /// Sets sources of the arguments and destinations of the results, for all later calls.
  void connect(std::size_t method, std::vector<Given> given, std::vector<Target> targets);
  /// Calls a method and stores its results.
  bool call(std::size_t method);

 private:
  /// Array argument, which is refilled before each call.
  struct Buffer {
    Held array;
    double* numbers = nullptr;
  };
  struct Bound {
    Held method;
    const char* shown = "";
    std::vector<Given> given{};
    std::vector<Target> targets{};
    std::vector<Buffer> buffers{};
    std::vector<_object*> arguments{};  ///< arguments of the current call
  };

  bool bind(const PythonClass& of);
  static bool fill(Bound& bound);

  Held object_;
  std::array<Bound, 3> methods_;
};

namespace {

constexpr std::array<const char*, 3> names{"outputs", "derivatives", "update"};

/// Converts a Python number; false after a Python exception.
bool write_number(PyObject* given, double* to) {
  const double number = PyFloat_CheckExact(given) ? PyFloat_AS_DOUBLE(given) : PyFloat_AsDouble(given);
  if (number == -1.0 && PyErr_Occurred()) return false;
  *to = number;
  return true;
}

/// Converts an array, which must have exactly the rows and columns of the target.
bool write_matrix(PyObject* given, const Target& target, const char* method) {
  const auto numbers = py::array_t<double, py::array::f_style | py::array::forcecast>::ensure(given);
  const Eigen::Index columns = target.size / target.rows;
  if (numbers && numbers.ndim() == 2 && numbers.shape(0) == target.rows && numbers.shape(1) == columns) {
    std::copy_n(numbers.data(), target.size, target.numbers);
    return true;
  }
  PyErr_Format(PyExc_ValueError, "%s() gives %R for %s, which is a matrix of %zd x %zd", method, given,
               target.name, static_cast<Py_ssize_t>(target.rows), static_cast<Py_ssize_t>(columns));
  return false;
}

bool write(PyObject* given, const Target& target, const char* method) {
  if (target.rows > 0) return write_matrix(given, target, method);
  if (target.size == 1 && (PyFloat_CheckExact(given) || !PySequence_Check(given)))
    return write_number(given, target.numbers);
  const auto numbers = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(given);
  if (!numbers) {
    PyErr_Format(PyExc_TypeError, "%s() gives %R for %s, which takes numbers", method, given, target.name);
    return false;
  }
  if (numbers.size() != target.size) {
    PyErr_Format(PyExc_ValueError, "%s() gives %zd numbers for %s, which has %zd", method,
                 static_cast<Py_ssize_t>(numbers.size()), target.name, static_cast<Py_ssize_t>(target.size));
    return false;
  }
  std::copy_n(numbers.data(), target.size, target.numbers);
  return true;
}

py::array_t<double> array_for(const Given& given) {
  if (given.rows == 0) return py::array_t<double>(given.size);
  const std::array<py::ssize_t, 2> shape{given.rows, given.size / given.rows};
  return py::array_t<double, py::array::f_style>(shape);
}

bool write_several(PyObject* given, const std::vector<Target>& targets, const char* method) {
  const Held items(PySequence_Fast(given, "several values are given as a tuple or a list"));
  if (!items) return false;
  const Py_ssize_t count = PySequence_Fast_GET_SIZE(items.get());
  if (count != static_cast<Py_ssize_t>(targets.size())) {
    PyErr_Format(PyExc_ValueError, "%s() gives %zd values and has to give %zd", method, count,
                 targets.size());
    return false;
  }
  for (std::size_t i = 0; i < targets.size(); ++i)
    if (!write(PySequence_Fast_GET_ITEM(items.get(), static_cast<Py_ssize_t>(i)), targets[i], method))
      return false;
  return true;
}

/// Describes an exception: "ValueError: a negative mass (Drag.outputs, drag.py:12)". The caller must hold the
/// interpreter lock.
std::string text_of(_object* exception) {
  try {
    const py::object shown = py::module_::import("stepwire.errors").attr("shown");
    return py::cast<std::string>(shown(py::reinterpret_borrow<py::object>(exception)));
  } catch (py::error_already_set&) {
    return "it raises an exception that has no text";
  }
}

constexpr std::size_t output_method = 0, slope_method = 1, update_method = 2;

const Method& method_of(const PythonClass& of, std::size_t method) {
  return method == output_method  ? of.output_method
         : method == slope_method ? of.slope_method
                                  : of.update_method;
}

Given given_to(const PythonBlock& block, const Argument& argument) {
  switch (argument.source) {
    case Source::input:
      return {block.inputs[argument.index].data(), block.inputs[argument.index].size(),
              block.of->inputs[argument.index].rows};
    case Source::state:
      return {block.states[argument.index].data(), block.states[argument.index].size(),
              block.of->states[argument.index].rows};
    case Source::memory:
      return {block.memory[argument.index].data(), block.memory[argument.index].size(),
              block.of->memory[argument.index].rows};
    case Source::time:
      return {&block.now, 1};
    default:
      return {&block.between, 1};
  }
}

}  // namespace

std::shared_ptr<Instance> Instance::make(const PythonClass& of, const Value* parameters) {
  auto made = std::make_shared<Instance>();
  try {
    const py::object kind = py::reinterpret_borrow<py::object>(of.made.get());
    py::object object = kind.attr("__new__")(kind);
    for (std::size_t i = 0; i < of.parameters.size(); ++i)
      object.attr(of.parameters[i].name.c_str()) =
          py::reinterpret_steal<py::object>(object_of(parameters[i]));
    object.attr("__init__")();
    made->object_ = Held(object.release().ptr());
  } catch (py::error_already_set& error) {
    error.restore();
    return nullptr;
  }
  return made->bind(of) ? made : nullptr;
}

bool Instance::bind(const PythonClass& of) {
  const std::array<const Method*, 3> methods{&of.output_method, &of.slope_method, &of.update_method};
  for (std::size_t i = 0; i < methods.size(); ++i) {
    if (!methods[i]->exists) continue;
    methods_[i].method = Held(PyObject_GetAttrString(object_.get(), names[i]));
    if (!methods_[i].method) return false;
    methods_[i].shown = methods[i]->shown.c_str();
    methods_[i].buffers.resize(methods[i]->arguments.size());
    methods_[i].arguments.resize(methods[i]->arguments.size());
  }
  return true;
}

/// Updates the arguments: a new float for each number, and the persistent array for each vector or matrix.
bool Instance::fill(Bound& bound) {
  const std::vector<Given>& given = bound.given;
  for (std::size_t i = 0; i < given.size(); ++i) {
    Buffer& buffer = bound.buffers[i];
    if (given[i].size == 1 && given[i].rows == 0) {
      buffer.array.put(PyFloat_FromDouble(*given[i].numbers));
    } else {
      if (!buffer.array) {
        py::array_t<double> array = array_for(given[i]);
        buffer.numbers = array.mutable_data();
        py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
        buffer.array = Held(array.release().ptr());
      }
      std::copy_n(given[i].numbers, given[i].size, buffer.numbers);
    }
    bound.arguments[i] = buffer.array.get();
    if (!bound.arguments[i]) return false;
  }
  return true;
}

void Instance::connect(std::size_t method, std::vector<Given> given, std::vector<Target> targets) {
  methods_[method].given = std::move(given);
  methods_[method].targets = std::move(targets);
}

bool Instance::call(std::size_t method) {
  Bound& bound = methods_[method];
  if (!fill(bound)) return false;
  const auto result = py::reinterpret_steal<py::object>(
      PyObject_Vectorcall(bound.method.get(), bound.arguments.data(), bound.arguments.size(), nullptr));
  if (!result) return false;
  if (bound.targets.empty()) return true;
  return bound.targets.size() == 1 ? write(result.ptr(), bound.targets.front(), bound.shown)
                                   : write_several(result.ptr(), bound.targets, bound.shown);
}

PythonBlock::PythonBlock(const PythonBlock& other)
    : of(other.of),
      inputs(other.inputs),
      results(other.results),
      states(other.states),
      memory(other.memory),
      values(other.values),
      failed(other.failed),
      t(other.t),
      period(other.period) {}

void PythonBlock::outputs() {
  call(output_method);
}

void PythonBlock::derivatives() {
  call(slope_method);
}

void PythonBlock::update() {
  call(update_method);
}

void PythonBlock::start() {
  why.clear();
  const Lock lock;
  instance = Instance::make(*of, values.data());
  if (!instance) return fail();
  for (const std::size_t method : {output_method, slope_method, update_method}) connect(method);
}

void PythonBlock::configure(Configure&) {
  const Lock lock;
  if (Instance::make(*of, values.data())) return;
  Raised raised;
  raised.keep();
  throw ParameterRefused("__init__", text_of(raised.latest()));
}

void PythonBlock::connect(std::size_t method) {
  std::vector<Given> given;
  for (const Argument& argument : method_of(*of, method).arguments)
    given.push_back(given_to(*this, argument));
  std::vector<Target> targets;
  if (method == output_method)
    for (std::size_t i = 0; i < of->outputs.size(); ++i)
      targets.push_back(
          {results[i].data(), results[i].size(), of->outputs[i].name.c_str(), of->outputs[i].rows});
  if (method == slope_method)
    for (std::size_t i = 0; i < of->states.size(); ++i)
      targets.push_back({states[i].derivative.data(), states[i].derivative.size(), of->states[i].name.c_str(),
                         of->states[i].rows});
  if (method == update_method)
    for (std::size_t i = 0; i < of->memory.size(); ++i)
      targets.push_back({memory[i].data(), memory[i].size(), of->memory[i].name.c_str(), of->memory[i].rows});
  instance->connect(method, std::move(given), std::move(targets));
}

/// Calls a method of the object. After the first failure it calls nothing, and the run ends at this tick.
void PythonBlock::call(std::size_t method) {
  if (!why.empty()) return;
  now = t;
  between = period;
  const Lock lock;
  if (!instance->call(method)) fail();
}

void PythonBlock::fail() {
  of->raised->keep();
  why = text_of(of->raised->latest());
  failed.raise(t);
}

void PythonBlock::declare(Declare<PythonBlock>& is) {
  is.block("Python", {.doc = "A class of Python's.",
                      .not_real_time = "its methods are Python's, of whose steps nothing bounds the time"});
  is.diagnostic<&PythonBlock::failed, [](const PythonBlock& block) { return block.why; }>(
      {.doc = "a method raised an exception", .ends_run = true});
  is.clock<&PythonBlock::t>();
  is.clock<&PythonBlock::period>();
}

}  // namespace stepwire::python
