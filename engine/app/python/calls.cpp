#include "engine/app/python/calls.hpp"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "engine/app/python/found.hpp"
#include "engine/app/python/numbers.hpp"
#include "engine/app/python/session_call.hpp"
#include "engine/app/report/linear_text.hpp"
#include "engine/app/report/loop_text.hpp"
#include "engine/app/report/run_text.hpp"
#include "engine/app/report/study_text.hpp"
#include "engine/app/session/linearizing.hpp"
#include "engine/app/session/loop_run.hpp"
#include "engine/stepwire/generate.hpp"
#include "engine/view/drawing/graph_faults.hpp"

namespace stepwire::python {

namespace py = pybind11;

namespace {

using Shared = std::shared_ptr<LoadedFile>;

void take_over(SessionCall& call, Results& results) {
  results.notes = call.notes();
  results.raised = call.take_raised();
  results.cause = call.take_cause();
}

std::shared_ptr<Results> run(const Shared& of, const std::string& engine, const py::list& observers,
                             const py::object& progress) {
  const auto results = std::make_shared<Results>();
  results->model = {of, &of->model()};
  SessionCall call(of, observers.ptr(), progress.ptr());
  call.make([&](session::Session& session) { results->outcome = session.run(of->model(), mode_of(engine)); });
  take_over(call, *results);
  results->words = report::outcome_text(*results->model, results->outcome);
  return results;
}

std::shared_ptr<Results> study(const Shared& of, const std::string& engine, unsigned threads,
                               const py::list& observers, const py::object& progress) {
  if (!of->model().study)
    throw yaml::Error(yaml::Fault{
        {of->call().file, {}}, "", "has no section 'study'; it names task, people and conditions", {}});
  const auto results = std::make_shared<Results>();
  const auto model = std::make_shared<session::LoadedModel>(of->model());
  results->model = model;
  SessionCall call(of, observers.ptr(), progress.ptr());
  call.make([&](session::Session& session) {
    const auto experiments = session.study(of->model(), {mode_of(engine), threads, {}});
    results->outcome = session::study_outcome(*model, *experiments);
    results->study = result::json_of(session::StudyReport{model.get(), experiments.get()}).text();
    results->words = report::study_text(*model, *experiments);
  });
  take_over(call, *results);
  results->words += report::outcome_text(*model, results->outcome);
  return results;
}

/// Linearizes the diagram, after trimming it if `trim`. Returns the result as JSON and as text.
py::tuple linearize(const Shared& of, const session::LinearCall& linear, bool trim) {
  std::string json, words;
  SessionCall call(of, nullptr, nullptr);
  call.make([&](session::Session& session) {
    session::LoadOptions options = of->model().options;
    if (trim) {
      const linear::TrimResult found = session::trim_file(session.registry(), of->call().file, options);
      if (!found.converged)
        throw yaml::Error(yaml::Fault{{of->call().file, {}}, "trim", "no such point was found", {}});
      for (diagram::Setting& setting : session::settings_of(found))
        options.settings.push_back(std::move(setting));
    }
    const linear::Analysis analysis =
        session::linearize_file(session.registry(), of->call().file, options, linear);
    json = result::json_of(analysis).text();
    words = report::linear_text(analysis);
  });
  call.throw_if_raised();
  return py::make_tuple(json, words);
}

py::tuple linearize_call(const Shared& of, std::vector<std::string> from, std::vector<std::string> to,
                         std::vector<std::string> open, double time, std::optional<double> difference,
                         std::optional<double> feedback, bool trim) {
  return linearize(of, {std::move(from), std::move(to), std::move(open), time, difference, feedback}, trim);
}

std::string draw(const Shared& of, std::vector<std::string> open, int depth, std::vector<std::string> hide,
                 bool units) {
  std::string svg;
  SessionCall call(of, nullptr, nullptr);
  call.make([&](session::Session& session) {
    diagram::Loader loader(session.registry(), of->model().options.limits, of->model().options.reader);
    const diagram::Diagram diagram = loader.load(of->call().file, of->call().settings);
    const drawing::DiagramView view(diagram, loader);
    drawing::GraphOptions options;
    options.open = std::move(open);
    options.depth = depth;
    options.hide = std::move(hide);
    options.units = units;
    yaml::Faults faults;
    for (const drawing::GraphFault& fault : drawing::faults_of(view, options))
      faults.add({{of->call().file, {}}, "", fault.message, {}});
    faults.throw_if_any();
    svg = drawing::draw_picture(view.graph(options));
  });
  call.throw_if_raised();
  return svg;
}

void generate(const Shared& of, const std::string& folder, const std::string& name) {
  SessionCall call(of, nullptr, nullptr);
  call.make(
      [&](session::Session&) { stepwire::generate(LoadedFile::library_model(of), folder, {.name = name}); });
  call.throw_if_raised();
}

/// Runs the real-time loop and returns its measurements as text.
std::string loop(const Shared& of, const std::string& duration, const std::string& rate,
                 const std::string& policy, const std::string& out) {
  std::string words;
  session::LoopCall request{of->call().file, of->model().options, {}, out};
  request.words.duration = duration;
  request.words.rate = rate;
  request.words.policy = policy;
  SessionCall call(of, nullptr, nullptr);
  call.make([&](session::Session& session) {
    session::run_loop(request, session.registry(), session.monitor(),
                      [&](const session::LoopOutcome& outcome) { words = report::loop_text(outcome); });
  });
  call.throw_if_raised();
  return words;
}

void add_numbers(py::class_<LoadedFile, Shared>& file) {
  file.def_property_readonly("path", [](const LoadedFile& of) { return of.call().file; })
      .def_property_readonly("title", [](const LoadedFile& of) { return of.model().job.plan.diagram.title; })
      .def_property_readonly("step", [](const LoadedFile& of) { return of.model().job.plan.diagram.step; })
      .def_property_readonly("stop", [](const LoadedFile& of) { return of.model().job.plan.diagram.stop; })
      .def_property_readonly("runs", [](const LoadedFile& of) { return of.model().job.points.size(); });
}

/// Returns the numpy shape of a signal: () for a number, (n,) for a vector, (rows, columns) for a matrix.
py::tuple shape_of(std::size_t size, std::size_t columns) {
  if (columns > 1) return py::make_tuple(size / columns, columns);
  return size == 1 ? py::tuple() : py::make_tuple(size);
}

py::list signals_of(const Shared& of) {
  py::list all;
  const Model model = LoadedFile::library_model(of);
  for (const SignalInfo& signal : model.signals())
    all.append(py::make_tuple(signal.name, signal.unit, signal.size, shape_of(signal.size, signal.columns)));
  return all;
}

py::list inputs_of(const Shared& of) {
  py::list all;
  const Model model = LoadedFile::library_model(of);
  for (const InputInfo& input : model.inputs())
    all.append(
        py::make_tuple(input.name, input.unit, input.size, input.doc, shape_of(input.size, input.columns)));
  return all;
}

py::list parameters_of(const Shared& of) {
  py::list all;
  const auto& written = of->model().job.plan.diagram.parameters;
  const std::vector<ParameterInfo> parameters = LoadedFile::library_model(of).parameters();
  for (std::size_t i = 0; i < parameters.size(); ++i)
    all.append(py::make_tuple(parameters[i].name, parameters[i].text,
                              py::reinterpret_steal<py::object>(object_of(written[i].value)),
                              parameters[i].unit, parameters[i].doc));
  return all;
}

}  // namespace

void add_calls(_object* module) {
  py::class_<LoadedFile, Shared> file(module, "File");
  add_numbers(file);
  file.def_property_readonly("signals", signals_of)
      .def_property_readonly("inputs", inputs_of)
      .def_property_readonly("parameters", parameters_of)
      .def("run", run)
      .def("study", study)
      .def("linearize", linearize_call)
      .def("draw", draw)
      .def("generate", generate)
      .def("loop", loop)
      .def("fit",
           [](const Shared& of, const std::string& engine, std::optional<std::size_t> starts,
              std::optional<std::uint64_t> seed, unsigned threads, const py::object& progress) {
             const session::FitCall call{starts, {}, seed, threads, mode_of(engine)};
             return fit_call(of, call, progress.ptr());
           })
      .def("tune", [](const Shared& of, const std::string& engine, std::optional<std::size_t> starts,
                      std::optional<std::size_t> evaluations, std::optional<std::uint64_t> seed,
                      std::optional<std::size_t> repeat, unsigned threads, const py::object& progress) {
        session::TuneCall call{starts, evaluations, repeat, seed, threads, mode_of(engine)};
        return tune_call(of, call, progress.ptr());
      });
}

}  // namespace stepwire::python
