#include "engine/app/session/tuning.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engine/analyse/study/study_columns.hpp"
#include "engine/analyse/tuning/search_items.hpp"
#include "engine/app/session/search_parts.hpp"
#include "engine/app/session/study_parts.hpp"
#include "engine/app/session/version.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/view/plot/figure_spec.hpp"
#include "engine/view/plot/plot_tools.hpp"
#include "engine/view/render/render.hpp"
#include "engine/view/scene/scene_states.hpp"

namespace stepwire::session {

namespace {

/// Study within an optimisation: performs the experiments with given parameter values. Subjects, noises and
/// orders are the same each time, so that only the values make a difference. All calls share plans and code.
class TunedStudy {
 public:
  /// The registry, the model and the pointers of the monitor must outlive the object. Throws Error.
  TunedStudy(const Registry& registry, const LoadedModel& model, const tuning::TuneRequest& request,
             const TuneCall& call, const Monitor& monitor);

  /// Returns the recordings of the experiments with these values; empty after an interruption, which `fault`
  /// then names. Thread-safe; calls are serialized. Throws Error if the diagram refuses the values.
  std::vector<record::Recording> run(const std::vector<diagram::Setting>& values, std::string& fault);
  /// Returns the reason of an interpreted run, if there was one.
  std::string take_problem() { return parts_->code.take_problem(); }

 private:
  void set_points(const std::vector<std::vector<diagram::Setting>>& values);

  const LoadedModel& model_;
  LoadedModel varied_;  ///< its points have the values of the current evaluation
  Monitor monitor_;
  diagram::Loader loader_;
  std::vector<std::uint64_t> seeds_;
  std::unique_ptr<StudyParts> parts_;
  std::mutex mutex_;
};

/// Offset from the start, as a fraction of a parameter's range. With several values the compiled code does
/// not fix those of the start.
constexpr double aside = 0.01;

/// Returns the settings of the start, and of values slightly above and below it.
std::vector<std::vector<diagram::Setting>> about_start(const tuning::TuneRequest& request) {
  std::vector<std::vector<diagram::Setting>> all;
  for (const double by : {0.0, aside, -aside}) {
    tuning::Values values;
    for (const tuning::TuneParameter& parameter : request.parameters)
      values.push_back(parameter.at(std::clamp(parameter.share_of(parameter.start) + by, 0.0, 1.0)));
    all.push_back(tuning::settings_of(request.parameters, values));
  }
  return all;
}

/// Returns the options of the repeated study.
StudyCall study_call(const TuneCall& call) {
  StudyCall study;
  study.engine = call.engine;
  study.threads = call.threads;
  return study;
}

TunedStudy::TunedStudy(const Registry& registry, const LoadedModel& model, const tuning::TuneRequest& request,
                       const TuneCall& call, const Monitor& monitor)
    : model_(model),
      varied_(load_model(registry, model.file, model.options)),
      loader_(registry, model.options.limits, model.options.reader) {
  monitor_.interrupt = monitor.interrupt;
  study::StudyRequest& own = *varied_.study;
  own.seed = request.study_seed.value_or(own.seed);
  own.experiments = request.experiments.value_or(own.experiments);
  run::Job& job = varied_.job;
  if (!job.family)
    job.family =
        std::make_shared<run::PlanFamily>(loader_, model.file, call_settings(model.options), job.plan);
  set_points(about_start(request));
  for (std::uint64_t i = 0; i < own.experiments; ++i) seeds_.push_back(own.seed + i);
  parts_ = std::make_unique<StudyParts>(registry, varied_, study_call(call),
                                        seeds_.size() * request.evaluations, monitor_);
}

/// Sets the points of the job: each point of the file's sweep, for each of these values.
void TunedStudy::set_points(const std::vector<std::vector<diagram::Setting>>& values) {
  run::Job& job = varied_.job;
  job.points.clear();
  job.trials = true;
  for (const std::vector<diagram::Setting>& tuned : values)
    for (std::size_t study = 0; study < study::study_count(model_.job); ++study) {
      run::SweepPoint& point = job.points.emplace_back();
      if (!model_.job.points.empty()) point.own = model_.job.settings_of(study);
      point.own.insert(point.own.end(), tuned.begin(), tuned.end());
      point.member = job.family->find(point.own);
    }
}

std::vector<record::Recording> TunedStudy::run(const std::vector<diagram::Setting>& values,
                                               std::string& fault) {
  const std::lock_guard lock(mutex_);
  set_points({values});
  KeptExperiments kept(varied_, {});
  const study::Experiments found = perform_here(*parts_->runs, varied_, seeds_, kept, monitor_);
  if (found.empty()) fault = "interrupted";
  return found.empty() ? std::vector<record::Recording>{}
                       : study::study_recordings(found, *varied_.study, model_.job);
}

tuning::TuneRequest request_of(const LoadedModel& model, const TuneCall& call) {
  tuning::TuneRequest request = *model.tune;
  if (call.starts) request.starts = *call.starts;
  if (call.evaluations) request.evaluations = *call.evaluations;
  if (call.seed) request.seed = *call.seed;
  if (call.experiments) request.experiments = call.experiments;
  return request;
}

/// Returns a lower bound of the number of runs of the searches.
double runs_of(const tuning::TuneRequest& request) {
  constexpr std::size_t per_parameter = 20;
  return static_cast<double>(std::min(per_parameter * request.parameters.size(), request.evaluations) *
                             request.starts);
}

struct TuneParts : SearchParts {
  TuneParts(const Registry& registry, const LoadedModel& model, const TuneCall& call, const Monitor& monitor)
      : SearchParts(registry, model, call.engine, runs_of(request_of(model, call))),
        request(request_of(model, call)),
        source{loader, model.file, settings, model.linear, used, monitor.interrupt} {
    if (model.study) {
      study.emplace(registry, model, request, call, monitor);
      source.code = nullptr;
      source.perform = [this](const std::vector<diagram::Setting>& values, std::string& fault) {
        return study->run(values, fault);
      };
    }
    if (model.scene)
      source.add_shown = [scene = model.scene](std::vector<record::Recording>& recordings) {
        scene::add_scene_states(*scene, recordings);
      };
  }

  tuning::TuneRequest request;
  tuning::TuneSource source;
  std::optional<TunedStudy> study{};

  std::string take_problem() { return study ? study->take_problem() : code.take_problem(); }
};

std::string unit_text(const std::optional<unit::Dimension>& dimension) {
  return dimension && *dimension != unit::Dimension{} ? unit::si_name(*dimension) : "";
}

constexpr std::size_t most_panels = 12;

/// Returns the indices of the evaluations that are feasible and the best so far.
std::vector<std::size_t> improvements(const tuning::TuneResult& result) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < result.history.size(); ++i) {
    const tuning::Evaluation& one = result.history[i];
    if (one.is_feasible() && (found.empty() || one.objective < result.history[found.back()].objective))
      found.push_back(i);
  }
  return found;
}

/// Returns a step curve: each value holds until the next improvement, the last one to the end.
template <class Value>
plot::NumberCurve steps_of(const tuning::TuneResult& result, const std::vector<std::size_t>& at, Value value,
                           const std::string& legend) {
  plot::NumberCurve curve{{}, {}, legend};
  for (std::size_t k = 0; k < at.size(); ++k) {
    const std::size_t end = k + 1 < at.size() ? at[k + 1] : result.history.size() - 1;
    for (const std::size_t x : {at[k], std::max(at[k], end)}) {
      curve.x.push_back(static_cast<double>(x + 1));
      curve.y.push_back(value(result.history[at[k]]));
    }
  }
  return curve;
}

/// True if all values are positive and the largest exceeds ten times the smallest.
bool spans_decades(const std::vector<double>& values) {
  if (values.empty()) return false;
  const auto [low, high] = std::ranges::minmax_element(values);
  return *low > 0.0 && *high > 10.0 * *low;
}

void finish_panel(plot::PlotBuilder& plot, const tuning::TuneResult& result) {
  plot::name_axis(plot.spec.x, "evaluation", "");
  plot::set_line_ranges(plot);
  plot.spec.x.range = {{1.0, std::max(2.0, static_cast<double>(result.history.size()))}};
}

void add_objective(const LoadedModel& model, const tuning::TuneResult& result,
                   const std::vector<std::size_t>& better, plot::FigureBuilder& panels) {
  plot::NumberCurve all{{}, {}, "each evaluation"};
  for (std::size_t i = 0; i < result.history.size(); ++i) {
    if (result.history[i].is_bad()) continue;
    all.x.push_back(static_cast<double>(i + 1));
    all.y.push_back(result.history[i].objective);
  }
  plot::PlotBuilder& plot = panels.add({.y = {.log = spans_decades(all.y)}});
  const auto& dimension = result.dimension;
  plot::name_axis(plot.spec.y,
                  model.tune->objective_text().size() <= 40 ? model.tune->objective_text() : "objective",
                  dimension && *dimension != unit::Dimension{} ? unit::si_name(*dimension) : "");
  std::vector<plot::NumberCurve> curves{std::move(all)};
  if (!better.empty())
    curves.push_back(steps_of(
        result, better, [](const tuning::Evaluation& one) { return one.objective; }, "best with all claims"));
  plot::draw_curves(curves, plot);
  finish_panel(plot, result);
}

void add_number(const tuning::TuneResult& result, std::size_t number, const std::vector<std::size_t>& better,
                plot::FigureBuilder& panels) {
  const tuning::TunedNumber& of = result.numbers[number];
  const unit::Unit unit = unit::parse_unit(of.unit).value_or(unit::Unit{});
  plot::NumberCurve curve = steps_of(
      result, better, [&](const tuning::Evaluation& one) { return unit.from_si(one.values[number]); }, "");
  plot::PlotBuilder& plot = panels.add({.y = {.log = spans_decades(curve.y)}});
  const bool si = of.unit.empty() && of.dimension && *of.dimension != unit::Dimension{};
  plot::name_axis(plot.spec.y, of.name, si ? unit::si_name(*of.dimension) : of.unit);
  plot::draw_curves({std::move(curve)}, plot);
  finish_panel(plot, result);
}

}  // namespace

tuning::TuneResult tune_model(const Registry& registry, const LoadedModel& model, const TuneCall& call,
                              const Monitor& monitor) {
  TuneParts parts(registry, model, call, monitor);
  tuning::TuneResult result =
      tuning::tune(parts.source, model.job, parts.request, {call.threads, monitor.progress, call.workers});
  result.file = model.file;
  result.minimise = model.tune->objective_text();
  monitor.note_interpreted(parts.take_problem());
  return result;
}

messages::ItemWork tune_work(const Registry& registry, const LoadedModel& model, const TuneCall& call) {
  const auto parts = std::make_shared<TuneParts>(registry, model, call, Monitor{});
  const auto work =
      std::make_shared<tuning::SearchWork>(parts->source, model.job, parts->request, call.threads);
  return [parts, work](const messages::Item& item) { return work->work(item); };
}

std::size_t most_searches(const LoadedModel& model, const TuneCall& call) {
  return request_of(model, call).starts;
}

std::string tune_key(const LoadedModel& model, const TuneCall& call) {
  const tuning::TuneRequest request = request_of(model, call);
  return fmt::format("{} {} {} {} {}", search_key(model), request.starts, request.evaluations, request.seed,
                     request.experiments.value_or(0));
}

LoadOptions with_tuned(LoadOptions options, const tuning::TuneResult& result) {
  options.settings.insert(options.settings.end(), result.settings.begin(), result.settings.end());
  return options;
}

void write_tune(const std::string& folder, const LoadedModel& model, const tuning::TuneResult& result) {
  io::write_file(folder + "/tune.json", result::json_of(result).text() + "\n");
  io::write_file(folder + "/tune-history.csv", history_csv(model, result));
  if (result.feasible && !result.numbers.empty())
    io::write_file(folder + "/parameters.yaml", parameters_text("Tuned by", model.file, result.settings));
  // An interruption would also end the renderer.
  if (!result.numbers.empty() && !result.interrupted)
    render::write_figure(folder, "tune-history", tune_figure(model, result));
}

std::string history_csv(const LoadedModel& model, const tuning::TuneResult& result) {
  enum State { holds, fails, failed };
  table::Table table{{{"evaluation", "", {}}, {"start", "", {}}, {"state", "", {}}}};
  for (const tuning::TunedNumber& number : result.numbers)
    table.columns.push_back({number.name, unit_text(number.dimension), {}});
  table.columns.push_back({"objective", unit_text(result.dimension), {}});
  const std::size_t claims = model.tune->constraints.size();
  for (std::size_t i = 0; i < claims; ++i) table.columns.push_back({fmt::format("margin.{}", i + 1), "", {}});
  for (std::size_t row = 0; row < result.history.size(); ++row) {
    const tuning::Evaluation& one = result.history[row];
    std::vector<double> cells{static_cast<double>(row + 1), static_cast<double>(one.start + 1),
                              static_cast<double>(one.is_bad()        ? failed
                                                  : one.is_feasible() ? holds
                                                                      : fails)};
    cells.insert(cells.end(), one.values.begin(), one.values.end());
    cells.push_back(one.objective);
    cells.insert(cells.end(), one.margins.begin(), one.margins.end());
    for (std::size_t i = 0; i < table.columns.size() && i < cells.size(); ++i)
      table.columns[i].values.push_back(cells[i]);
  }
  return table::csv_text(table, {{"state", {"holds", "fails", "no objective"}}});
}

plot::FigureSpec tune_figure(const LoadedModel& model, const tuning::TuneResult& result) {
  const std::vector<std::size_t> better = improvements(result);
  const std::size_t numbers = better.empty() ? 0 : std::min(result.numbers.size(), most_panels - 1);
  plot::FigureBuilder panels({.title = "Tuning, evaluation by evaluation", .columns = numbers > 3 ? 2 : 1},
                             numbers + 1);
  add_objective(model, result, better, panels);
  for (std::size_t i = 0; i < numbers; ++i) add_number(result, i, better, panels);
  return panels.finished();
}

}  // namespace stepwire::session
