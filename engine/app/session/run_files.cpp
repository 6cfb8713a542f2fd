#include "engine/app/session/run_files.hpp"

#include <set>
#include <utility>

#include "engine/app/session/kept_points.hpp"
#include "engine/app/session/sweep_sections.hpp"
#include "engine/app/session/version.hpp"
#include "engine/base/io/file.hpp"
#include "engine/simulate/replay/replay_folder.hpp"
#include "engine/simulate/run/pooling.hpp"
#include "engine/view/plot/figure_spec.hpp"
#include "engine/view/render/render.hpp"
#include "engine/view/render/scene_drawing.hpp"

namespace stepwire::session {

using json::Json;

namespace {

constexpr std::size_t max_listed = 10'000;  // Longest list of values of an axis; sweep.csv has all values.

/// Returns the axes of the sweep. Words are in the order in which a MAT file numbers them from 0.
Json sweep_json(const run::Job& job) {
  if (job.points.empty()) return {};
  Json axes = Json::list();
  for (const diagram::Sweep::Axis& axis : job.plan.diagram.sweep->axes) {
    Json values = Json::list();
    const auto words = run::has_words(axis) ? run::words_of(axis) : std::vector<std::string>{};
    const std::size_t count = words.empty() ? axis.count() : words.size();
    for (std::size_t i = 0; count <= max_listed && i < count; ++i)
      values.push(without_quotes(words.empty() ? axis.text(i) : words[i]));
    axes.push(
        Json::object().set("parameter", axis.parameter).set("count", count).set("values", std::move(values)));
  }
  return axes;
}

/// Returns the kind of data that a sweep keeps of each run; null for a single run.
Json kept_word(const LoadedModel& model) {
  if (model.kept) return "numbers";
  const auto& sweep = model.job.plan.diagram.sweep;
  if (model.job.points.empty() || !sweep) return {};
  return sweep->keep == diagram::Sweep::Keep::final ? "final" : "rows";
}

/// Returns the expressions of the kept numbers by name; null if there are none.
Json kept_texts(const LoadedModel& model) {
  if (!model.kept) return {};
  Json texts = Json::object();
  for (const yaml::Entry& entry : model.job.plan.diagram.sweep->kept.entries)
    texts.set(entry.key, entry.value.text);
  return texts;
}

/// Returns the numbers, from 1, of the runs whose rows are recorded in addition to the kept numbers; null
/// without any.
Json recorded_runs(const LoadedModel& model) {
  if (!model.kept || recordings_of(model) == 1) return {};
  Json runs = Json::list();
  for (const std::size_t point : model.job.plan.diagram.sweep->recorded_points()) runs.push(point + 1);
  return runs;
}

Json parameter_value(const diagram::DiagramParameter& parameter) {
  if (const double* number = std::get_if<double>(&parameter.value.content)) return *number;
  return parameter.text;
}

Json parameters_json(const diagram::Diagram& diagram) {
  Json list = Json::list();
  for (const diagram::DiagramParameter& parameter : diagram.parameters)
    list.push(Json::object()
                  .set("name", parameter.name)
                  .set("value", parameter_value(parameter))
                  .set("unit", parameter.dimension ? Json(unit::si_name(*parameter.dimension)) : Json())
                  .set("written", parameter.text)
                  .set("assumed", parameter.assumed)
                  .set("set", parameter.set));
  return list;
}

Json fault_texts(const Outcome& outcome) {
  Json faults = Json::list();
  for (const run::RunFault& fault : outcome.result.faults) faults.push(fault.fault.text());
  return faults;
}

void write_scene(const std::string& folder, const LoadedModel& model, const Outcome& outcome,
                 std::vector<std::string>& pictures) {
  pictures.emplace_back("scene.svg");
  io::write_file(
      folder + "/" + pictures.back(),
      render::animated_scene(*model.scene, model.file, outcome.recordings(), model.job.plan.diagram.title));
}

}  // namespace

Json claims_json(const LoadedModel& model, const Outcome& outcome) {
  Json list = Json::list();
  const auto& figure = model.job.plan.diagram.reproduces.figure;
  for (const claim::Verdict& verdict : outcome.verdicts) {
    Json claim = Json::object();
    claim.set("file", model.file).set("figure", figure ? Json(*figure) : Json()).set("that", verdict.that);
    claim.set("check", verdict.check).set("value", verdict.value).set("holds", verdict.holds);
    if (verdict.kind == claim::Claim::Kind::invariant) claim.set("invariant", true);
    if (!verdict.disagrees.empty()) claim.set("disagrees", verdict.disagrees);
    if (verdict.interval)
      claim.set("interval", Json::list({verdict.interval->low, verdict.interval->high}))
          .set("confidence", verdict.confidence);
    if (!verdict.worst.empty()) claim.set("worst", verdict.worst);
    if (!verdict.note.empty()) claim.set("note", verdict.note);
    list.push(std::move(claim));
  }
  return list;
}

Json diagnostics_json(const Outcome& outcome) {
  Json diagnostics = Json::list();
  for (const run::RaisedDiagnostic& raised : outcome.result.diagnostics)
    diagnostics.push(
        Json::object().set("block", raised.block).set("time", raised.time).set("text", raised.text));
  return diagnostics;
}

/// Returns the number of lanes in which runs were stepped together, and the reason for runs without lanes;
/// null for a single run.
Json lanes_json(const run::Job& job, const run::RunResult& result) {
  if (job.points.empty()) return nullptr;
  const Json why = result.lanes.why_not.empty() ? Json(nullptr) : Json(result.lanes.why_not);
  return Json::object().set("count", result.lanes.count).set("ticks", result.lane_ticks).set("why_not", why);
}

Json algebraic_loops_json(const std::vector<run::LoopCost>& loops) {
  Json list = Json::list();
  for (const run::LoopCost& loop : loops)
    list.push(Json::object()
                  .set("loop", loop.path)
                  .set("unknowns", loop.unknowns)
                  .set("instants", loop.instants)
                  .set("iterations", loop.iterations)
                  .set("max_iterations", loop.most)
                  .set("unsolved", loop.unsolved)
                  .set("first_unsolved", loop.unsolved > 0 ? Json(loop.first_unsolved) : Json()));
  return list;
}

/// Returns the counts of adaptive steps; null without error control.
static Json steps_json(const diagram::Diagram& diagram, const run::StepCount& steps) {
  if (!diagram.error_control) return {};
  return Json::object()
      .set("relative", diagram.error_control->relative)
      .set("absolute", diagram.error_control->absolute)
      .set("accepted", steps.accepted)
      .set("rejected", steps.rejected)
      .set("largest_error", steps.largest_error)
      .set("stiff", diagram.solver == "auto" ? Json(steps.stiff) : Json());
}

/// Returns the counts of located events; null without event location.
static Json events_json(const diagram::Diagram& diagram, const run::EventCount& events) {
  if (!diagram.events.locate) return {};
  return Json::object().set("located", events.located).set("most_in_a_step", events.most_in_a_step);
}

/// Returns the head of the file as it was run.
static Json head_json(const LoadedModel& model) {
  const diagram::Diagram& diagram = model.job.plan.diagram;
  return Json::object()
      .set("file", model.file)
      .set("title", diagram.title)
      .set("hash", model.hash)
      .set("parameters", parameters_json(diagram))
      .set("step", diagram.step)
      .set("stop", diagram.stop)
      .set("solver", diagram.solver.empty() ? Json() : Json(diagram.solver));
}

Json run_json(const LoadedModel& model, const Outcome& outcome) {
  const diagram::Diagram& diagram = model.job.plan.diagram;
  return head_json(model)
      .set("sweep", sweep_json(model.job))
      .set("keep", kept_word(model))
      .set("kept", kept_texts(model))
      .set("recorded_runs", recorded_runs(model))
      .set("runs", model.job.points.empty() ? std::size_t{1} : model.job.points.size())
      .set("ticks", outcome.result.ticks)
      .set("compiled_ticks", outcome.result.compiled_ticks)
      .set("lanes", lanes_json(model.job, outcome.result))
      .set("blocks", diagram.blocks.size())
      .set("block_folders", Json::list_of(model.blocksets))
      .set("algebraic_loops", algebraic_loops_json(outcome.result.loops))
      .set("solver_steps", steps_json(diagram, outcome.result.steps))
      .set("events", events_json(diagram, outcome.result.events))
      .set("notices", diagnostics_json(outcome))
      .set("findings", Json::list_of(findings_of(model, outcome)))
      .set("faults", fault_texts(outcome))
      .set("interrupted", outcome.result.interrupted)
      .set("version", program_version())
      .set("compiler", compiler_version())
      .set("duration", outcome.seconds);
}

std::vector<std::string> write_outputs(const std::string& folder, const LoadedModel& model,
                                       const Outcome& outcome, const FileKinds& kinds,
                                       const render::PictureKinds& drawn) {
  if (!outcome.rows_passed) write_signals(folder, model, outcome.result.recordings, kinds);
  io::write_file(folder + "/claims.json", claims_json(model, outcome).text() + "\n");
  io::write_file(folder + "/run.json", run_json(model, outcome).text() + "\n");
  std::vector<std::string> pictures;
  // The recordings of an early end are kept, but a picture of them could be mistaken for that of a whole run.
  if (!outcome.result.faults.empty() || outcome.result.interrupted) return pictures;
  for (std::size_t i = 0; i < model.figures.size(); ++i) {
    const std::string name = io::numbered("figure", i, "");
    for (const render::PictureKind kind : drawn) pictures.push_back(name + render::ending_of(kind));
    render::write_figure(folder, name, plot::figure_spec(model.figures[i], outcome.recordings()), {}, drawn);
  }
  if (model.scene) write_scene(folder, model, outcome, pictures);
  return pictures;
}

std::unique_ptr<io::OwnedFolder> own_results(const std::string& folder, const LoadedModel& model,
                                             const FileKinds& kinds) {
  if (folder.empty()) return nullptr;
  auto owned = std::make_unique<io::OwnedFolder>(folder, [&] {
    std::set<std::string> files = replay::files_read(model.job);
    files.insert({folder + "/experiments.csv", folder + "/experiments.json", points_path(folder)});
    for (const char* of : {"study", "fit", "tune"}) files.insert(items_path(folder, of));
    if (model.study && !model.study->trials.empty()) files.insert(model.study->trials);
    return files;
  });
  std::vector<std::string> names = signal_file_names(kinds);
  names.insert(names.end(), {"claims.json", "run.json"});
  owned->reserve(names);
  return owned;
}

}  // namespace stepwire::session
