#include "engine/app/python/results.hpp"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "engine/app/python/faults.hpp"
#include "engine/app/python/watched_call.hpp"
#include "engine/app/session/run_files.hpp"
#include "engine/app/session/run_result.hpp"
#include "engine/simulate/replay/replay_folder.hpp"
#include "engine/simulate/run/pooling.hpp"
#include "engine/view/render/render.hpp"

namespace stepwire::python {

namespace py = pybind11;

namespace {

const record::Recording& recording_of(const Results& of, std::size_t index) {
  if (index >= of.outcome.result.recordings.size()) throw py::index_error("there is no such recording");
  return of.outcome.result.recordings[index];
}

py::list columns(const Results& of, std::size_t recording) {
  py::list all;
  for (const table::Column& column : recording_of(of, recording).table.columns)
    all.append(py::make_tuple(column.name, column.unit));
  return all;
}

/// Returns a read-only view of a column, which keeps the results alive.
py::array column(const py::object& self, std::size_t recording, std::size_t index) {
  const table::Table& table = recording_of(self.cast<const Results&>(), recording).table;
  if (index >= table.columns.size()) throw py::index_error("there is no such column");
  const std::vector<double>& values = table.columns[index].values;
  py::array_t<double> view(static_cast<py::ssize_t>(values.size()), values.data(), self);
  py::detail::array_proxy(view.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return view;
}

py::dict categories(const Results& of, std::size_t recording) {
  py::dict all;
  for (const record::Categories& column : recording_of(of, recording).categories) {
    py::list texts;
    for (const std::string& text : column.texts) texts.append(session::without_quotes(text));
    all[py::str(column.column)] = texts;
  }
  return all;
}

/// Returns the judged claims as JSON, with the fields that no file has.
std::string claims(const Results& of) {
  json::Json list = json::Json::list();
  for (const session::JudgedClaim& claim : session::judged_claims(*of.model, of.outcome))
    list.push(result::record_type<session::JudgedClaim>().json_of(&claim, true));
  return list.text(-1);
}

py::list faults(const Results& of) {
  py::list all;
  for (const run::RunFault& fault : of.outcome.result.faults) {
    const auto tuples = py::reinterpret_steal<py::list>(fault_tuples({fault.fault}));
    all.append(py::make_tuple(fault.block, fault.port, fault.time, tuples[0]));
  }
  return all;
}

/// Returns the settings of each run of a sweep as a dictionary of names and texts.
py::list points(const Results& of) {
  py::list all;
  for (std::size_t point = 0; point < of.model->job.points.size(); ++point) {
    py::dict sets;
    for (const diagram::Setting& setting : of.model->job.settings_of(point))
      sets[py::str(setting.name)] = session::without_quotes(setting.value);
    all.append(sets);
  }
  return all;
}

std::string figure(const Results& of, std::size_t index) {
  if (index >= of.model->figures.size()) throw py::index_error("there is no such figure");
  std::string svg;
  call_checked([&] { svg = render::draw(of.model->figures[index], of.outcome.recordings()).svg; });
  return svg;
}

void write_results(const Results& of, const std::string& folder) {
  call_checked([&] {
    const auto owned = session::own_results(folder, *of.model);
    replay::write_replay(folder, of.model->job);
    session::write_outputs(folder, *of.model, of.outcome);
  });
}

py::object object_or_none(const Held& held) {
  return held ? py::reinterpret_borrow<py::object>(held.get()) : py::none();
}

void add_ends(py::class_<Results, std::shared_ptr<Results>>& results) {
  results
      .def_property_readonly("interrupted", [](const Results& of) { return of.outcome.result.interrupted; })
      .def_property_readonly("early", [](const Results& of) { return of.outcome.early(); })
      .def_property_readonly("ticks", [](const Results& of) { return of.outcome.result.ticks; })
      .def_property_readonly("compiled_ticks",
                             [](const Results& of) { return of.outcome.result.compiled_ticks; })
      .def_property_readonly("seconds", [](const Results& of) { return of.outcome.seconds; })
      .def_property_readonly(
          "figures", [](const Results& of) { return of.outcome.early() ? 0 : of.model->figures.size(); })
      .def("figure", figure)
      .def("write", write_results)
      .def_property_readonly("json",
                             [](const Results& of) {
                               return result::json_of(session::RunReport{of.model.get(), &of.outcome}).text();
                             })
      .def_property_readonly("raised", [](const Results& of) { return object_or_none(of.raised); })
      .def_property_readonly("cause", [](const Results& of) { return object_or_none(of.cause); })
      .def_readonly("notes", &Results::notes)
      .def_readonly("study", &Results::study)
      .def_readonly("words", &Results::words);
}

}  // namespace

void add_results(_object* module) {
  py::class_<Results, std::shared_ptr<Results>> results(module, "Results");
  add_ends(results);
  results
      .def_property_readonly("recordings",
                             [](const Results& of) { return of.outcome.result.recordings.size(); })
      .def("columns", columns)
      .def("column", column)
      .def("categories", categories)
      .def("starts",
           [](const Results& of, std::size_t recording) { return recording_of(of, recording).starts; })
      .def_property_readonly("claims", claims)
      .def_property_readonly("faults", faults)
      .def_property_readonly("points", points);
}

}  // namespace stepwire::python
