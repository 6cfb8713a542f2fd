#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "engine/app/python/calls.hpp"
#include "engine/app/python/loaded_file.hpp"
#include "engine/app/python/numbers.hpp"
#include "engine/app/python/python_class.hpp"
#include "engine/app/python/watched_call.hpp"
#include "engine/model/block/registry.hpp"
#include "engine/simulate/blockset/blockset.hpp"

namespace stepwire::python {

namespace py = pybind11;

namespace {

/// Returns the rows in a shape, 3 of "3 x 2"; 0 for a vector.
Eigen::Index rows_of(const std::string& shape) {
  return shape.find(" x ") == std::string::npos ? 0 : std::stol(shape);
}

std::vector<PythonClass::Port> ports_of(const py::list& listed) {
  std::vector<PythonClass::Port> ports;
  for (const py::handle port : listed) {
    const auto [name, unit, shape, feedthrough, initial] =
        port.cast<std::tuple<std::string, std::string, std::string, bool, double>>();
    ports.push_back({name, unit, shape, feedthrough, initial, rows_of(shape)});
  }
  return ports;
}

Value value_of(const py::handle& value) {
  if (py::isinstance<py::bool_>(value)) return {value.cast<bool>()};
  if (py::isinstance<py::str>(value)) return {value.cast<std::string>()};
  if (!py::isinstance<py::list>(value)) return {value.cast<double>()};
  const auto numbers = value.cast<std::vector<double>>();
  return {Eigen::VectorXd(
      Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size())))};
}

std::vector<PythonClass::Parameter> parameters_of(const py::list& listed) {
  std::vector<PythonClass::Parameter> parameters;
  for (const py::handle parameter : listed) {
    const auto [name, unit, value, required] =
        parameter.cast<std::tuple<std::string, std::string, py::object, bool>>();
    parameters.push_back({name, unit, "", value_of(value), required});
  }
  return parameters;
}

/// Describes a method by its displayed name and its arguments, (source, index) each; None if the class has no
/// such method.
Method method_of(const std::string& shown, const py::object& arguments) {
  Method method;
  method.shown = shown;
  if (arguments.is_none()) return method;
  method.exists = true;
  for (const py::handle argument : arguments) {
    const auto [source, index] = argument.cast<std::pair<int, std::size_t>>();
    method.arguments.push_back({static_cast<Source>(source), index});
  }
  return method;
}

std::shared_ptr<const PythonClass> class_of(const py::dict& declared, std::shared_ptr<Raised> raised) {
  const auto made = std::make_shared<PythonClass>();
  made->name = declared["name"].cast<std::string>();
  made->doc = declared["doc"].cast<std::string>();
  made->place = declared["place"].cast<std::string>();
  made->made = Held(py::object(declared["class"]).release().ptr());
  made->inputs = ports_of(declared["inputs"]);
  made->outputs = ports_of(declared["outputs"]);
  made->states = ports_of(declared["states"]);
  made->memory = ports_of(declared["memory"]);
  made->parameters = parameters_of(declared["parameters"]);
  made->output_method = method_of(made->name + ".outputs", declared["output_method"]);
  made->slope_method = method_of(made->name + ".derivatives", declared["slope_method"]);
  made->update_method = method_of(made->name + ".update", declared["update_method"]);
  made->raised = std::move(raised);
  return made;
}

std::shared_ptr<const Kinds> kinds_of(Registry known, const py::list& classes,
                                      const std::vector<std::string>& folders) {
  const auto kinds = std::make_shared<Kinds>();
  kinds->registry = std::move(known);
  if (folders.empty())
    blockset::load_blocksets_of_environment(kinds->registry);
  else
    for (const std::string& folder : folders) blockset::load_blockset(folder, kinds->registry);
  for (const py::handle declared : classes) try {
      kinds->registry.add(type_of(class_of(py::reinterpret_borrow<py::dict>(declared), kinds->raised)));
    } catch (const std::logic_error& error) {  // a duplicate name, or too many ports
      throw py::value_error(error.what());
    }
  return kinds;
}

LoadCall call_of(const std::string& path, const py::list& settings, const py::object& stop,
                 const py::dict& sections) {
  LoadCall call{path};
  for (const py::handle setting : settings) {
    const auto [name, text] = setting.cast<std::pair<std::string, std::string>>();
    call.settings.push_back({name, text, name + "=\"" + text + "\""});
  }
  if (!stop.is_none()) call.stop = stop.cast<std::string>();
  for (const auto& [key, section] : sections)
    call.sections.push_back({key.cast<std::string>(), {}, node_of(section.ptr())});
  return call;
}

using Shared = std::shared_ptr<LoadedFile>;

Shared load(std::shared_ptr<const Kinds> kinds, std::shared_ptr<KeptDocuments> documents, LoadCall call) {
  Shared loaded;
  Raised raised;
  call_watched(
      [&](std::atomic<bool>&) {
        loaded = std::make_shared<LoadedFile>(std::move(kinds), std::move(documents), std::move(call));
      },
      raised);
  raised.throw_if_any();
  return loaded;
}

Shared load_anew(Registry known, const std::string& path, const py::list& settings, const py::object& stop,
                 const py::dict& sections, const py::list& classes, const std::vector<std::string>& folders) {
  return load(kinds_of(std::move(known), classes, folders), std::make_shared<KeptDocuments>(),
              call_of(path, settings, stop, sections));
}

/// Loads the cached files again with other values.
Shared load_again(const Shared& of, const py::list& settings, const py::object& stop,
                  const py::dict& sections) {
  return load(of->kinds(), of->documents(), call_of(of->call().file, settings, stop, sections));
}

}  // namespace

void add_loading(_object* module, Registry (*blocks)()) {
  auto to = py::reinterpret_borrow<py::module_>(module);
  to.def("load", [blocks](const std::string& path, const py::list& settings, const py::object& stop,
                          const py::dict& sections, const py::list& classes,
                          const std::vector<std::string>& folders) {
    return load_anew(blocks(), path, settings, stop, sections, classes, folders);
  });
  to.def("load_again", load_again);
}

}  // namespace stepwire::python
