#include "engine/app/session/loaded_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "engine/analyse/linear/columns.hpp"
#include "engine/analyse/query/varied.hpp"
#include "engine/analyse/study/study_columns.hpp"
#include "engine/analyse/study/study_tables.hpp"
#include "engine/app/session/sweep_sections.hpp"
#include "engine/base/yaml/error.hpp"
#include "engine/model/diagram/diagram.hpp"
#include "engine/model/diagram/flatten.hpp"
#include "engine/model/diagram/named_signals.hpp"
#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/run/memory.hpp"
#include "engine/view/drawing/draw.hpp"
#include "engine/view/plot/drawn.hpp"
#include "engine/view/scene/scene_states.hpp"

namespace stepwire::session {

namespace {

using Names = std::map<std::string, diagram::SignalRef>;

/// Returns the fault of a name; std::nullopt if it is an output.
std::optional<yaml::Message> wrong_with(const std::string& name, const Names& names) {
  const auto found = names.find(name);
  if (found != names.end() && found->second.output >= 0) return std::nullopt;
  if (found != names.end()) return fmt::format("'{}' is a state; name an output of a block", name);
  std::vector<std::string> all;
  for (const auto& [known, signal] : names)
    if (signal.output >= 0) all.push_back(known);
  return fmt::format("there is no signal '{}'", name) + yaml::did_you_mean(name, all);
}

/// Checks the names in `pointer` of a scene. Each must be an output of the diagram, a port of a part or an
/// output of a block. Unknown names become faults that suggest the nearest name.
void check_pointer_names(const diagram::Diagram& diagram, yaml::Faults& faults) {
  const yaml::Node* pointer = diagram.scene.find("pointer");
  if (!pointer) return;
  const Names names = diagram::named_signals(diagram);
  const auto check = [&](const std::string& key, const yaml::Node& node) {
    if (node.kind != yaml::Node::Kind::scalar) return;  // the form check has reported this
    if (const auto wrong = wrong_with(node.text, names))
      faults.add({{diagram.file, node.mark}, "scene.pointer." + key, *wrong, {}});
  };
  for (const yaml::Entry& entry : pointer->entries) {
    check(entry.key, entry.value);
    for (const yaml::Node& item : entry.value.items) check(entry.key, item);
  }
}

/// Reads the section `study`, and adds the names that it defines.
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
  query::mark_varied(diagram, {study::varied_by_trials(*model.study), "set by the study for each trial"},
                     names);
  model.tables = names.tables = study::empty_study_tables();
}

/// Reads the sections `trim` and `linear`, and adds the names that they define.
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

/// Marks the parameters that a fit finds for each of several records.
void mark_fitted_apart(const LoadedModel& model, query::SymbolTable& names) {
  if (model.job.points.size() < 2) return;
  query::VariedNames apart{{}, "found for each record"};
  for (const estimation::FitParameter& parameter : model.fit->parameters)
    if (parameter.each_record) apart.names.push_back(parameter.name);
  query::mark_varied(model.job.plan.diagram, apart, names);
}

/// Reads the sections that evaluate runs, and adds their names. The fit is read first, with the names of all
/// rows, because it does not depend on the numbers that the sweep keeps.
void read_analyses(diagram::Loader& loader, LoadedModel& model, query::SymbolTable& names,
                   yaml::Faults& faults) {
  const diagram::Diagram& diagram = model.job.plan.diagram;
  const std::size_t before = faults.size();
  if (diagram.fit.kind != yaml::Node::Kind::empty)
    model.fit = estimation::read_fit(diagram.fit, names, diagram, faults);
  if (model.fit && faults.size() == before) mark_fitted_apart(model, names);
  add_kept(model, names, faults);
  add_linear(loader, model, names, faults);
  add_sensitivity(model, names, faults);
}

/// Checks the optimisation of a study: its trials must be simulated, and its parameters must not be those
/// that the study sets for each trial.
void check_tuned_study(const LoadedModel& model, yaml::Faults& faults) {
  const study::StudyRequest& request = *model.study;
  if (!request.trials.empty())
    faults.add({model.tune->place,
                "tune",
                fmt::format("the trials of {} were recorded as they are", request.trials),
                {}});
  const std::vector<std::string> own = study::set_for_each_trial(request);
  for (const tuning::TuneParameter& parameter : model.tune->parameters)
    if (std::ranges::find(own, parameter.name) != own.end())
      faults.add({parameter.place,
                  "tune.parameters." + parameter.name,
                  "the study sets this for each trial; what all of its trials share is tuned",
                  {}});
  const std::size_t experiments = model.job.plan.diagram.records.size() + 1;
  for (const claim::Claim& reduction : model.tune->minimise.reductions)
    if (reduction.recording != experiments)
      faults.add({model.tune->place,
                  "tune.minimise",
                  fmt::format(
                      "'{}' is of each trial; a study is tuned by what comes out of its experiments, such as "
                      "mean.{}; 'toward' takes claims on trials as well",
                      reduction.values.front().text, request.conditions.front().name),
                  {}});
}

/// Adds a fault for keys of `tune` that need a study, in a file without one.
void refuse_study_keys(const yaml::Node& section, const std::string& file, yaml::Faults& faults) {
  for (const char* key : {"experiments", "study_seed"})
    if (const yaml::Node* node = section.find(key))
      faults.add({{file, node->mark},
                  std::string("tune.") + key,
                  "goes with a section 'study', which this file does not have; leave it out",
                  {}});
}

/// Reads the section `tune`, after all sections whose names its claims may use.
void add_tuning(diagram::Loader& loader, LoadedModel& model, const query::SymbolTable& names,
                yaml::Faults& faults) {
  const yaml::Node* section = loader.document(model.file).root.find("tune");
  if (!section) return;
  if (has_cases(model))
    return faults.add({{model.file, section->mark}, "tune", "has single runs; leave out 'cases'", {}});
  model.tune = tuning::read_tune(*section, names, model.job.plan.diagram, model.linear, faults);
  if (!model.study) return refuse_study_keys(*section, model.file, faults);
  check_tuned_study(model, faults);
}

/// Reads the scene before figures and claims, which may use the names of its states.
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

/// Reads the figures.
void read_all_figures(const diagram::Diagram& diagram, LoadedModel& model, const query::SymbolTable& names,
                      yaml::Faults& faults) {
  if (diagram.figure.kind != yaml::Node::Kind::empty)
    model.figures = plot::read_figures(diagram.figure, names_of_figures(model, names), faults);
  draw_kept_as_points(model, model.figures);
}

/// Adds the source of the trials of a study to the titles of its pictures.
void add_source_of_trials(LoadedModel& model) {
  if (!model.study) return;
  for (plot::Figure& figure : model.figures)
    if (!figure.title.empty()) figure.title += fmt::format(" ({})", study::whose_trials(*model.study));
}

/// Reads claims and invariants, which may use quantities that figures draw and the scene shows.
void read_all_claims(const diagram::Diagram& diagram, LoadedModel& model, query::SymbolTable& names,
                     yaml::Faults& faults) {
  std::ranges::move(plot::drawn_quantities(model.figures, names), std::back_inserter(names.drawn));
  if (model.scene) std::ranges::move(plot::shown_quantities(*model.scene), std::back_inserter(names.drawn));
  const auto read = [&](const yaml::Node& section, claim::Claim::Kind kind) {
    if (section.kind == yaml::Node::Kind::empty) return;
    std::ranges::move(claim::read_claims(section, kind, names, faults), std::back_inserter(model.claims));
  };
  read(diagram.claims, claim::Claim::Kind::statement);
  read(diagram.invariants, claim::Claim::Kind::invariant);
}

}  // namespace

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
  model.job = run::make_job(loader, file, options.settings, options.stop, options.of_points, options.threads);
  if (options.figure) model.job.plan.diagram.figure = *options.figure;
  query::SymbolTable names = kept::names_of(model.job);
  yaml::Faults faults;
  const diagram::Diagram& diagram = model.job.plan.diagram;
  const drawing::DiagramView view(diagram, loader);
  names.diagram = &view;
  add_study(loader, options, model, names, faults);
  if (model.study) run::require_memory_of_all_rows(model.job);
  read_analyses(loader, model, names, faults);
  names.scene = model.scene = read_scene_of(diagram, names, faults);
  read_all_figures(diagram, model, names, faults);
  read_all_claims(diagram, model, names, faults);
  add_source_of_trials(model);
  add_tuning(loader, model, names, faults);
  faults.throw_if_any();
  model.hash = diagram::diagram_hash(diagram);
  return model;
}

}  // namespace stepwire::session
