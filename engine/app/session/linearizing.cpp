#include "engine/app/session/linearizing.hpp"

#include <algorithm>

#include "engine/analyse/linear/columns.hpp"
#include "engine/app/session/search_parts.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/mat/mat_file.hpp"
#include "engine/simulate/run/pooling.hpp"

namespace stepwire::session {

using linear::Analysis;
using linear::Complex;

namespace {

std::vector<linear::WrittenName> written(const std::vector<std::string>& names, const std::string& subject) {
  std::vector<linear::WrittenName> all;
  for (const std::string& name : names) all.push_back({name, {subject + " " + name, {}}, ""});
  return all;
}

template <class Ports>
void add_all(const Ports& ports, std::vector<linear::WrittenName>& names) {
  if (!names.empty()) return;
  for (const auto& port : ports) names.push_back({port.name});
}

void require(const std::string& file, const std::vector<linear::WrittenName>& names, const char* option,
             const char* section) {
  if (!names.empty()) return;
  throw yaml::Error(yaml::Fault{
      {file, {}}, "", yaml::fault_text("the diagram has no '{}'; give {} SIGNAL", section, option), {}});
}

/// Loads the diagram of a point of the sweep, or of the single run.
diagram::Diagram diagram_of(diagram::Loader& loader, const LoadedModel& model, std::size_t point) {
  std::vector<diagram::Setting> settings = call_settings(model.options);
  if (model.job.points.empty()) return loader.load(model.file, settings);
  for (diagram::Setting& setting : model.job.settings_of(point)) settings.push_back(std::move(setting));
  return loader.load_point(model.file, settings);
}

std::vector<std::string> names_of(const std::vector<linear::Channel>& channels) {
  std::vector<std::string> names;
  for (const linear::Channel& channel : channels) names.push_back(channel.name);
  return names;
}

std::vector<std::string> units_of(const std::vector<linear::Channel>& channels) {
  std::vector<std::string> units;
  for (const linear::Channel& channel : channels) units.push_back(channel.unit);
  return units;
}

std::vector<Complex> poles_of(const Analysis& analysis) {
  std::vector<Complex> poles;
  for (const linear::Mode& mode : analysis.modes) poles.push_back(mode.pole);
  return poles;
}

mat::NamedMatrix named(const char* name, const Eigen::MatrixXd& matrix) {
  return {name,
          static_cast<std::size_t>(matrix.rows()),
          static_cast<std::size_t>(matrix.cols()),
          {matrix.data(), matrix.data() + matrix.size()}};
}

std::vector<double> delay_times(const linear::StateSpace& system) {
  std::vector<double> times;
  for (const linear::InnerDelay& delay : system.delays) times.push_back(delay.time);
  return times;
}

/// Converts complex numbers to rows [re, im].
mat::NamedMatrix named(const char* name, const std::vector<Complex>& numbers) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(numbers.size()), 2);
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    rows.row(i) << numbers[static_cast<std::size_t>(i)].real(), numbers[static_cast<std::size_t>(i)].imag();
  return named(name, rows);
}

/// Adds what an analysis could not determine, once for all points of a sweep.
void add_notes(const linear::NamedAnalysis& named, const Analysis& analysis,
               std::vector<run::RaisedDiagnostic>& diagnostics) {
  for (const std::string& note : analysis.channels.front().margins.notes) {
    const bool known = std::ranges::any_of(diagnostics, [&](const run::RaisedDiagnostic& diagnostic) {
      return diagnostic.block == named.name && diagnostic.text == note;
    });
    if (!known) diagnostics.push_back({named.name, note, analysis.time});
  }
}

}  // namespace

Analysis linearize_file(const Registry& registry, const std::string& file, const LoadOptions& options,
                        const LinearCall& call) {
  diagram::Loader loader(registry, options.limits, options.reader);
  diagram::Diagram diagram = loader.load(file, options.settings);
  linear::Request request{written(call.from, "--from"), written(call.to, "--to"),
                          written(call.open, "--open"), call.time, call.size};
  add_all(diagram.inputs, request.from);
  add_all(diagram.outputs, request.to);
  require(file, request.from, "--from", "inputs");
  require(file, request.to, "--to", "outputs");
  Analysis analysis = linear::analyse(linear::linearize(std::move(diagram), request), call.feedback);
  analysis.file = file;
  return analysis;
}

std::vector<record::Recording> linear_recordings(const LoadedModel& model,
                                                 std::vector<run::RaisedDiagnostic>& diagnostics) {
  std::vector<record::Recording> recordings(model.linear.size());
  if (model.linear.empty()) return recordings;
  diagram::Loader loader(*model.registry, model.options.limits, model.options.reader);
  const run::SweptColumns swept(model.job);
  for (std::size_t point = 0; point < std::max<std::size_t>(1, model.job.points.size()); ++point) {
    const diagram::Diagram diagram = diagram_of(loader, model, point);
    for (std::size_t i = 0; i < model.linear.size(); ++i) {
      const linear::NamedAnalysis& named = model.linear[i];
      const Analysis analysis = linear::analyse(linear::linearize(diagram, named.request), named.feedback);
      record::Recording one = linear::analysis_recording(named, analysis);
      add_notes(named, analysis, diagnostics);
      if (!model.job.points.empty()) swept.add(one, point);
      run::append_runs(recordings[i], std::move(one));
    }
  }
  return recordings;
}

void write_linear(const std::string& folder, const Analysis& analysis) {
  const linear::StateSpace& system = analysis.system;
  io::write_file(folder + "/linear.json", result::json_of(analysis).text() + "\n");
  mat::write_mat(folder + "/linear.mat",
                 {named("A", system.A),
                  named("B", system.B),
                  named("C", system.C),
                  named("D", system.D),
                  named("poles", poles_of(analysis)),
                  named("zeros", analysis.zeros),
                  {"sample_time", 1, 1, {system.sample_time}},
                  {"delays", system.delays.size(), 1, delay_times(system)}},
                 {{"states", names_of(system.states)},
                  {"inputs", names_of(system.all_inputs())},
                  {"outputs", names_of(system.all_outputs())},
                  {"state_units", units_of(system.states)},
                  {"input_units", units_of(system.all_inputs())},
                  {"output_units", units_of(system.all_outputs())}});
}

}  // namespace stepwire::session
