#include "engine/app/python/tunings.hpp"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "engine/app/python/session_call.hpp"
#include "engine/app/python/watched_call.hpp"
#include "engine/app/report/tune_text.hpp"
#include "engine/view/render/render.hpp"

namespace stepwire::python {

namespace py = pybind11;

namespace {

py::list settings_of(const Tuning& of) {
  py::list all;
  for (const diagram::Setting& setting : of.result.settings)
    all.append(py::make_tuple(setting.name, setting.value));
  return all;
}

/// Returns values, objective, margins, start and fault of each evaluation.
py::list history_of(const Tuning& of) {
  py::list all;
  for (const tuning::Evaluation& one : of.result.history)
    all.append(py::make_tuple(one.values, one.objective, one.margins, one.start + 1, one.fault));
  return all;
}

std::string picture_of(const Tuning& of) {
  Raised raised;
  std::string svg;
  call_watched(
      [&](std::atomic<bool>&) {
        svg = render::render(session::tune_figure(of.file->model(), of.result)).svg;
      },
      raised);
  raised.throw_if_any();
  return svg;
}

}  // namespace

std::shared_ptr<Tuning> tune_call(const std::shared_ptr<LoadedFile>& of, const session::TuneCall& request,
                                  _object* progress) {
  if (!of->model().tune)
    throw yaml::Error(yaml::Fault{
        {of->call().file, {}}, "", "has no section 'tune'; it names parameters and what is minimised", {}});
  const auto tuning = std::make_shared<Tuning>();
  tuning->file = of;
  SessionCall call(of, nullptr, progress);
  call.make([&](session::Session& session) { tuning->result = session.tune(of->model(), request); });
  tuning->notes = call.notes();
  call.throw_if_raised();
  return tuning;
}

void add_tunings(_object* module) {
  py::class_<Tuning, std::shared_ptr<Tuning>>(module, "Tuning")
      .def_property_readonly(
          "json", [](const Tuning& of) { return session::tune_json(of.file->model(), of.result).text(); })
      .def_property_readonly("words", [](const Tuning& of) { return report::tune_text(of.result); })
      .def_property_readonly("settings", settings_of)
      .def_property_readonly("history", history_of)
      .def("figure", picture_of)
      .def_readonly("notes", &Tuning::notes);
}

}  // namespace stepwire::python
