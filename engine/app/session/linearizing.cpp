#include "engine/app/session/linearizing.hpp"

#include <algorithm>

#include "engine/analyse/linear/columns.hpp"
#include "engine/app/session/matrix_json.hpp"
#include "engine/app/session/search_parts.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/mat/mat_file.hpp"
#include "engine/simulate/run/pooling.hpp"

namespace stepwire::session {

using json::Json;

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

Json complex_json(const Complex& number) {
  return Json::list({number.real(), number.imag()});
}

Json complex_list(const std::vector<Complex>& numbers) {
  Json list = Json::list();
  for (const Complex& number : numbers) list.push(complex_json(number));
  return list;
}

std::vector<Complex> poles_of(const Analysis& analysis) {
  std::vector<Complex> poles;
  for (const linear::Mode& mode : analysis.modes) poles.push_back(mode.pole);
  return poles;
}

Json modes_json(const std::vector<linear::Mode>& modes) {
  Json list = Json::list();
  for (const linear::Mode& mode : modes)
    list.push(Json::object()
                  .set("pole", complex_json(mode.pole))
                  .set("natural_frequency", mode.frequency)
                  .set("damping", mode.damping));
  return list;
}

Json crossings_json(const std::vector<linear::Crossing>& crossings) {
  Json list = Json::list();
  for (const linear::Crossing& crossing : crossings)
    list.push(Json::object().set("frequency", crossing.frequency).set("margin", crossing.margin));
  return list;
}

Json nearest_json(const std::optional<linear::Crossing>& crossing, bool known) {
  if (!crossing || !known) return Json();
  return Json::object().set("frequency", crossing->frequency).set("margin", crossing->margin);
}

Json modulus_json(const linear::Margins& margins) {
  if (!margins.knows_modulus) return Json();
  return Json::object().set("frequency", margins.modulus_frequency).set("margin", margins.modulus);
}

Json margins_json(const linear::Margins& margins, double feedback) {
  return Json::object()
      .set("feedback", feedback)
      .set("stable", margins.knows_stability ? Json(margins.stable) : Json())
      .set("gain", nearest_json(margins.worst_gain(), margins.knows_gain && margins.knows_stability))
      .set("phase", nearest_json(margins.worst_phase(), margins.knows_phase && margins.knows_stability))
      .set("delay", margins.delay())
      .set("modulus", modulus_json(margins))
      .set("gain_crossings", crossings_json(margins.gain))
      .set("phase_crossings", crossings_json(margins.phase))
      .set("closed_poles", complex_list(margins.closed_poles))
      .set("not_determined", Json::list_of(margins.notes));
}

Json zeros_json(const Analysis& analysis, const std::vector<Complex>& zeros) {
  return analysis.system.delays.empty() ? complex_list(zeros) : Json();
}

Json channels_json(const Analysis& analysis) {
  Json list = Json::list();
  for (const linear::ChannelAnalysis& channel : analysis.channels)
    list.push(Json::object()
                  .set("input", channel.input)
                  .set("output", channel.output)
                  .set("zeros", zeros_json(analysis, channel.zeros))
                  .set("gain_at_rest", channel.gain_at_rest)
                  .set("bandwidth", channel.bandwidth)
                  .set("margins", margins_json(channel.margins, analysis.feedback)));
  return list;
}

Json rank_json(const Analysis& analysis, const linear::Rank& rank) {
  if (!analysis.system.delays.empty()) return Json();
  return Json::object().set("rank", rank.rank).set("singular_values", Json::list_of(rank.singular_values));
}

Json values_json(const std::vector<linear::PointValue>& values) {
  Json object = Json::object();
  for (const linear::PointValue& value : values) object.set(value.channel.name, value.value);
  return object;
}

Json point_json(const Analysis& analysis) {
  return Json::object()
      .set("time", analysis.time)
      .set("states", values_json(analysis.states))
      .set("rates", Json::list_of(analysis.rates))
      .set("inputs", values_json(analysis.inputs))
      .set("outputs", values_json(analysis.outputs));
}

Json error_json(const linear::StateSpace& error) {
  return Json::object()
      .set("A", matrix_json(error.A))
      .set("B", matrix_json(error.B))
      .set("C", matrix_json(error.C))
      .set("D", matrix_json(error.D));
}

/// Returns the inner delays. Each connects an additional output to an additional input, after those of the
/// system.
Json delays_json(const linear::StateSpace& system) {
  Json list = Json::list();
  for (const linear::InnerDelay& delay : system.delays)
    list.push(
        Json::object().set("time", delay.time).set("output", delay.out.name).set("input", delay.in.name));
  return list;
}

Json units_json(const linear::StateSpace& system) {
  return Json::object()
      .set("states", Json::list_of(units_of(system.states)))
      .set("inputs", Json::list_of(units_of(system.all_inputs())))
      .set("outputs", Json::list_of(units_of(system.all_outputs())));
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

Json system_json(const std::string& file, const linear::StateSpace& system) {
  return Json::object()
      .set("file", file)
      .set("A", matrix_json(system.A))
      .set("B", matrix_json(system.B))
      .set("C", matrix_json(system.C))
      .set("D", matrix_json(system.D))
      .set("states", Json::list_of(names_of(system.states)))
      .set("inputs", Json::list_of(names_of(system.all_inputs())))
      .set("outputs", Json::list_of(names_of(system.all_outputs())))
      .set("delays", delays_json(system))
      .set("units", units_json(system))
      .set("sample_time", system.sample_time);
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
  return linear::analyse(linear::linearize(std::move(diagram), request), call.feedback);
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

Json linear_json(const std::string& file, const Analysis& analysis) {
  Json result = system_json(file, analysis.system)
                    .set("poles", complex_list(poles_of(analysis)))
                    .set("zeros", zeros_json(analysis, analysis.zeros))
                    .set("modes", modes_json(analysis.modes))
                    .set("stable", analysis.stable)
                    .set("controllability", rank_json(analysis, analysis.controllable))
                    .set("observability", rank_json(analysis, analysis.observable))
                    .set("channels", channels_json(analysis));
  if (analysis.system.has_one_channel())
    result.set("margins", margins_json(analysis.channels[0].margins, analysis.feedback));
  return result.set("point", point_json(analysis))
      .set("error", error_json(analysis.error))
      .set("method", analysis.method)
      .set("notes", Json::list_of(analysis.notes));
}

void write_linear(const std::string& folder, const std::string& file, const Analysis& analysis) {
  const linear::StateSpace& system = analysis.system;
  io::write_file(folder + "/linear.json", linear_json(file, analysis).text() + "\n");
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
