// More than 300 lines with its header: the sections of a file are read in one place, in the order in which they name each other.
#include "engine/app/session/loaded_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <unordered_set>

#include "engine/analyse/linear/columns.hpp"
#include "engine/analyse/study/study_columns.hpp"
#include "engine/analyse/study/study_tables.hpp"
#include "engine/app/session/pointer_names.hpp"
#include "engine/app/session/sweep_sections.hpp"
#include "engine/model/diagram/flatten.hpp"
#include "engine/model/diagram/output_names.hpp"
#include "engine/model/diagram/signal_words.hpp"
#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/run/pooling.hpp"
#include "engine/view/drawing/draw.hpp"
#include "engine/view/plot/drawn.hpp"
#include "engine/view/scene/scene_states.hpp"

namespace stepwire::session {

namespace {

void add_swept_names(const run::Job& job, query::SymbolTable& names) {
  if (job.points.empty()) return;
  for (const diagram::Sweep::Axis& axis : job.plan.diagram.sweep->axes) {
    query::RecordedName name{axis.parameter, std::nullopt, std::nullopt};
    if (axis.label) name.words = run::words_of(axis);
    for (const diagram::DiagramParameter& parameter : job.plan.diagram.parameters) {
      if (parameter.name != axis.parameter) continue;
      name.dimension = parameter.dimension;
      if (!std::holds_alternative<double>(parameter.value.content))
        for (const std::string& word : run::words_of(axis)) name.words.push_back(unquoted(word));
    }
    names.columns.push_back(std::move(name));
  }
}

void add_signals(const diagram::Diagram& diagram, query::SymbolTable& names) {
  for (const diagram::DiagramBlock& block : diagram.blocks) {
    const auto& outputs = block.type().outputs;
    if (diagram::has_one_output(block.type())) names.signals.push_back(block.name);
    for (const OutputSpec& output : outputs) names.signals.push_back(block.name + "." + output.name);
  }
}

void add_outlines(const diagram::Diagram& diagram, query::SymbolTable& names) {
  for (const diagram::DiagramBlock& block : diagram.blocks) {
    if (!block.type().outline) continue;
    names.outlines.push_back({block.name, {}});
    block.type().outline(block.block.get(), names.outlines.back().outline);
  }
}

/// A number of a block as an expression has it; empty where the unit is that of what is wired to it.
std::string number_text(const ParameterSpec& spec, double value) {
  const auto unit = unit::parse_unit(spec.unit);
  if (!unit) return {};
  std::string name = unit->dimension == unit::Dimension{} ? "" : " " + unit::si_name(unit->dimension);
  std::replace(name.begin() + (name.empty() ? 0 : 1), name.end(), ' ', '.');
  return fmt::format("{}{}", value, name);
}

/// What has a name already, recorded or not: a set, since a large diagram has very many.
using Taken = std::unordered_set<std::string_view>;

/// Adds a number of a block where its name is free.
void add_number(const std::string& name, const ParameterSpec& spec, double value, const Taken& taken,
                query::SymbolTable& names) {
  if (!std::isfinite(value) || taken.contains(name)) return;
  if (std::string text = number_text(spec, value); !text.empty())
    names.drawn.push_back({name, std::move(text)});
}

/// Numbers that blocks were given, by their file, a preset or as defaults: "rig.damper.beta"; of a list
/// "rig.damper.alpha.2".
void add_numbers_of_blocks(const diagram::Diagram& diagram, query::SymbolTable& names) {
  Taken taken(names.signals.begin(), names.signals.end());
  for (const query::RecordedName& column : names.columns) taken.insert(column.name);
  for (const diagram::DiagramBlock& block : diagram.blocks)
    for (const ParameterSpec& spec : block.type().parameters) {
      const Value value = spec.get(block.block.get());
      const std::string name = block.name + "." + spec.name;
      if (const auto* number = std::get_if<double>(&value.content))
        add_number(name, spec, *number, taken, names);
      const auto* list = std::get_if<Eigen::VectorXd>(&value.content);
      if (list && list->size() == 1) add_number(name, spec, (*list)[0], taken, names);
      for (Eigen::Index k = 0; list && list->size() > 1 && k < list->size(); ++k)
        add_number(fmt::format("{}.{}", name, k + 1), spec, (*list)[k], taken, names);
    }
}

/// What figures and claims of a file may name.
query::SymbolTable names_of(const run::Job& job) {
  const diagram::Diagram& diagram = job.plan.diagram;
  query::SymbolTable names{diagram.file, {}, {}};
  names.columns.push_back({"time", unit::parse_unit("s")->dimension, std::nullopt});
  add_swept_names(job, names);
  for (std::size_t r = 0; r < diagram.records.size(); ++r) {
    const auto columns = record::recorded_columns(job.plan, diagram.records[r]);
    for (std::size_t i = 1; i < columns.size(); ++i)
      names.columns.push_back({columns[i].name, columns[i].dimension, r});
    for (const diagram::RecordedSignal& signal : diagram.records[r].signals)
      for (query::RecordedName& column : names.columns)
        if (column.name == signal.name) column.words = diagram::signal_words(diagram, signal.signal);
  }
  for (const diagram::DiagramParameter& parameter : diagram.parameters)
    if (const double* number = std::get_if<double>(&parameter.value.content))
      names.parameters.push_back({parameter.name, *number, parameter.dimension});
  add_signals(diagram, names);
  add_outlines(diagram, names);
  add_numbers_of_blocks(diagram, names);
  return names;
}

/// Reads what the file asks of a study, and adds the names that it makes.
void add_study(diagram::Loader& loader, const LoadOptions& options, LoadedModel& model,
               query::SymbolTable& names, yaml::Faults& faults) {
  const yaml::Node* section = loader.document(model.file).root.find("study");
  if (!section) return;
  const diagram::Diagram& diagram = model.job.plan.diagram;
  if (diagram.fit.kind != yaml::Node::Kind::empty)
    faults.add({{model.file, section->mark}, "study", "a file has a study or a fit, not both", {}});
  model.study = study::read_study(*section, names, diagram, loader, options.study, faults);
  faults.throw_if_any();
  study::check_carry(*model.study, model.job.plan, faults);
  faults.throw_if_any();
  study::add_study_names(*model.study, diagram, names);
  model.tables = names.tables = study::empty_study_tables(!model.job.points.empty());
}

/// Reads what the file asks of linear analysis, and adds the names that it makes.
void add_linear(diagram::Loader& loader, LoadedModel& model, query::SymbolTable& names,
                yaml::Faults& faults) {
  const yaml::Node& root = loader.document(model.file).root;
  if (const yaml::Node* section = root.find("trim"))
    model.trim = linear::read_trim(*section, names, model.job.plan, faults);
  const yaml::Node* section = root.find("linear");
  if (!section) return;
  if (model.study)
    return faults.add(
        {{model.file, section->mark}, "linear", "a file has a study or 'linear', not both", {}});
  model.linear = linear::read_linear(*section, names, model.job.plan, faults);
  std::size_t recording = recordings_of(model);
  for (const linear::NamedAnalysis& analysis : model.linear)
    std::ranges::move(linear::analysis_names(analysis, recording++), std::back_inserter(names.columns));
}

/// Reads what is made of the runs, and adds its names. A fit reads all rows, whatever the sweep keeps.
void read_analyses(diagram::Loader& loader, LoadedModel& model, query::SymbolTable& names,
                   yaml::Faults& faults) {
  const diagram::Diagram& diagram = model.job.plan.diagram;
  if (diagram.fit.kind != yaml::Node::Kind::empty)
    model.fit = estimation::read_fit(diagram.fit, names, diagram, faults);
  add_kept(model, names, faults);
  add_linear(loader, model, names, faults);
  add_sensitivity(model, names, faults);
}

/// Reads the section `tune`, after all that its claims may name.
void add_tuning(diagram::Loader& loader, LoadedModel& model, const query::SymbolTable& names,
                yaml::Faults& faults) {
  const yaml::Node* section = loader.document(model.file).root.find("tune");
  if (!section) return;
  if (model.study)
    return faults.add({{model.file, section->mark}, "tune", "a file has a study or 'tune', not both", {}});
  if (has_cases(model))
    return faults.add({{model.file, section->mark}, "tune", "has single runs; leave out 'cases'", {}});
  model.tune = tuning::read_tune(*section, names, model.job.plan.diagram, model.linear, faults);
}

/// Reads the scene ahead of figures and claims, which may name what it shows.
std::shared_ptr<const scene::Scene> read_scene_of(const diagram::Diagram& diagram, query::SymbolTable& names,
                                                  yaml::Faults& faults) {
  if (diagram.scene.kind == yaml::Node::Kind::empty) return nullptr;
  const std::size_t before = faults.size();
  auto scene = std::make_shared<const scene::Scene>(scene::read_scene(diagram.scene, names, faults));
  if (faults.size() == before)
    std::ranges::copy(scene::scene_state_names(*scene), std::back_inserter(names.columns));
  if (faults.size() == before) check_pointer_names(diagram, faults);
  return scene;
}

/// Figures of a study say whose trials they show.
void read_all_figures(const diagram::Diagram& diagram, LoadedModel& model, const query::SymbolTable& names,
                      yaml::Faults& faults) {
  if (diagram.figure.kind != yaml::Node::Kind::empty)
    model.figures = plot::read_figures(diagram.figure, names, faults);
  draw_kept_as_points(model, model.figures);
  if (!model.study) return;
  for (plot::Figure& figure : model.figures)
    if (!figure.title.empty()) figure.title += fmt::format(" ({})", study::whose_trials(*model.study));
}

/// Claims and invariants may name what the figures draw and the scene shows.
void read_all_claims(const diagram::Diagram& diagram, LoadedModel& model, query::SymbolTable& names,
                     yaml::Faults& faults) {
  std::ranges::move(plot::drawn_quantities(model.figures), std::back_inserter(names.drawn));
  if (model.scene) std::ranges::move(plot::shown_quantities(*model.scene), std::back_inserter(names.drawn));
  const auto read = [&](const yaml::Node& section, claim::Claim::Kind kind) {
    if (section.kind == yaml::Node::Kind::empty) return;
    std::ranges::move(claim::read_claims(section, kind, names, faults), std::back_inserter(model.claims));
  };
  read(diagram.claims, claim::Claim::Kind::statement);
  read(diagram.invariants, claim::Claim::Kind::invariant);
}

}  // namespace

std::string unquoted(const std::string& word) {
  const bool quoted = word.size() > 1 && word.front() == '"' && word.back() == '"';
  return quoted ? word.substr(1, word.size() - 2) : word;
}

LoadedModel load_model(const Registry& registry, const std::string& file, const LoadOptions& options) {
  diagram::Loader loader(registry, options.limits, options.reader);
  return load_model(loader, file, options);
}

LoadedModel load_model(diagram::Loader& loader, const std::string& file, const LoadOptions& options) {
  LoadedModel model;
  model.file = file;
  model.options = options;
  model.registry = &loader.registry();
  model.blocksets = loader.registry().blocksets();
  model.job = run::make_job(loader, file, options.settings, options.stop, options.of_points);
  query::SymbolTable names = names_of(model.job);
  yaml::Faults faults;
  const diagram::Diagram& diagram = model.job.plan.diagram;
  const drawing::DiagramView view(diagram, loader);
  names.diagram = &view;
  add_study(loader, options, model, names, faults);
  read_analyses(loader, model, names, faults);
  names.scene = model.scene = read_scene_of(diagram, names, faults);
  read_all_figures(diagram, model, names, faults);
  read_all_claims(diagram, model, names, faults);
  add_tuning(loader, model, names, faults);
  faults.throw_if_any();
  model.hash = diagram::diagram_hash(diagram);
  return model;
}

}  // namespace stepwire::session
