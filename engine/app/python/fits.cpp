#include "engine/app/python/fits.hpp"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "engine/app/python/calls.hpp"
#include "engine/app/python/session_call.hpp"
#include "engine/app/python/watched_call.hpp"
#include "engine/app/report/fit_text.hpp"
#include "engine/view/render/render.hpp"

namespace stepwire::python {

namespace py = pybind11;

namespace {

py::list settings_of(const Fit& of) {
  py::list all;
  const session::LoadOptions options = session::with_fitted({}, of.result);
  for (const diagram::Setting& setting : options.settings)
    all.append(py::make_tuple(setting.name, setting.value));
  return all;
}

std::string picture(const Fit& of, std::size_t index) {
  if (index >= of.pictures.size()) throw py::index_error("there is no such figure");
  Raised raised;
  std::string svg;
  call_watched([&](std::atomic<bool>&) { svg = render::render(of.pictures[index].figure).svg; }, raised);
  raised.throw_if_any();
  return svg;
}

py::list picture_names(const Fit& of) {
  py::list all;
  for (const session::FitPicture& picture : of.pictures) all.append(picture.name);
  return all;
}

void require_fit(const LoadedFile& of) {
  if (of.model().fit) return;
  throw yaml::Error(
      yaml::Fault{{of.call().file, {}}, "", "has no section 'fit'; it names parameters and records", {}});
}

}  // namespace

std::shared_ptr<Fit> fit_call(const std::shared_ptr<LoadedFile>& of, const std::string& engine,
                              std::optional<std::size_t> starts, std::optional<std::uint64_t> seed,
                              unsigned threads, _object* progress) {
  require_fit(*of);
  session::FitCall request;
  request.starts = starts;
  request.seed = seed;
  request.threads = threads;
  request.engine = mode_of(engine);
  const auto fit = std::make_shared<Fit>();
  fit->file = of;
  SessionCall call(of, nullptr, progress);
  call.make([&](session::Session& session) {
    fit->result = session.fit(of->model(), request);
    if (!fit->result.records.empty()) fit->pictures = session::fit_pictures(*of->model().fit, fit->result);
  });
  fit->notes = call.notes();
  call.throw_if_raised();
  return fit;
}

void add_fits(_object* module) {
  py::class_<Fit, std::shared_ptr<Fit>>(module, "Fit")
      .def_property_readonly(
          "json", [](const Fit& of) { return session::fit_json(of.file->model(), of.result).text(); })
      .def_property_readonly("words", [](const Fit& of) { return report::fit_text(of.result); })
      .def_property_readonly("settings", settings_of)
      .def_property_readonly("figures", picture_names)
      .def("figure", picture)
      .def_readonly("notes", &Fit::notes);
}

}  // namespace stepwire::python
