#include "engine/app/session/linearizing.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/linear/columns.hpp"
#include "engine/app/session/search_parts.hpp"
#include "engine/simulate/run/pooling.hpp"

namespace stepwire::session {

using linear::Analysis;

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
  return linear::analyse(linear::linearize(std::move(diagram), request), call.feedback);
}

namespace {

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

}  // namespace stepwire::session
