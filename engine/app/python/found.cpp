#include "engine/app/python/found.hpp"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "engine/app/python/session_call.hpp"
#include "engine/app/python/watched_call.hpp"
#include "engine/app/report/fit_text.hpp"
#include "engine/app/report/tune_text.hpp"
#include "engine/view/render/render.hpp"

namespace stepwire::python {

namespace py = pybind11;

namespace {

py::list settings_of(const Found& of) {
  py::list all;
  for (const diagram::Setting& setting : of.settings) all.append(py::make_tuple(setting.name, setting.value));
  return all;
}

/// Returns values, objective, margins, start and fault of each evaluation.
py::list history_of(const Found& of) {
  py::list all;
  for (const tuning::Evaluation& one : of.history)
    all.append(py::make_tuple(one.values, one.objective, one.margins, one.start + 1, one.fault));
  return all;
}

py::list picture_names(const Found& of) {
  py::list all;
  for (const session::FitPicture& picture : of.pictures) all.append(picture.name);
  return all;
}

std::string picture(const Found& of, std::size_t index) {
  if (index >= of.pictures.size()) throw py::index_error("there is no such figure");
  std::string svg;
  call_checked([&] { svg = render::render(of.pictures[index].figure).svg; });
  return svg;
}

/// Makes the call of a session that searches for parameters. Throws Error if the file has no section for it.
template <class Search>
std::shared_ptr<Found> found(const File& of, bool has_section, const char* lack, _object* progress,
                             const Search& search) {
  if (!has_section) throw yaml::Error(yaml::Fault{{of->call().file, {}}, "", lack, {}});
  const auto found = std::make_shared<Found>();
  SessionCall call(of, nullptr, progress);
  call.make([&](session::Session& session) { search(session, *found); });
  found->notes = call.notes();
  call.throw_if_raised();
  return found;
}

}  // namespace

std::shared_ptr<Found> fit_call(const File& of, const session::FitCall& request, _object* progress) {
  const session::LoadedModel& model = of->model();
  return found(of, model.fit.has_value(), "has no section 'fit'; it names parameters and records", progress,
               [&](session::Session& session, Found& found) {
                 const estimation::FitResult result = session.fit(model, request);
                 found.json = result::json_of(result).text();
                 found.words = report::fit_text(result);
                 found.settings = session::with_fitted({}, result).settings;
                 if (!result.records.empty()) found.pictures = session::fit_pictures(*model.fit, result);
               });
}

std::shared_ptr<Found> tune_call(const File& of, const session::TuneCall& request, _object* progress) {
  const session::LoadedModel& model = of->model();
  return found(of, model.tune.has_value(), "has no section 'tune'; it names parameters and what is minimised",
               progress, [&](session::Session& session, Found& found) {
                 const tuning::TuneResult result = session.tune(model, request);
                 found.json = result::json_of(result).text();
                 found.words = report::tune_text(result);
                 found.settings = result.settings;
                 found.pictures = {{"tune-history", session::tune_figure(model, result)}};
                 found.history = result.history;
               });
}

void add_found(_object* module) {
  py::class_<Found, std::shared_ptr<Found>>(module, "Found")
      .def_readonly("json", &Found::json)
      .def_readonly("words", &Found::words)
      .def_property_readonly("settings", settings_of)
      .def_property_readonly("history", history_of)
      .def_property_readonly("figures", picture_names)
      .def("figure", picture)
      .def_readonly("notes", &Found::notes);
}

}  // namespace stepwire::python
