// Fields of the result of a study.
#include "engine/analyse/study/comparison_tables.hpp"
#include "engine/analyse/study/side_by_side.hpp"
#include "engine/app/session/studies.hpp"
#include "engine/base/io/file.hpp"

namespace stepwire::session {

using result::Map;
using result::path;
using result::Record;

/// A scored trial, with its run if it was simulated.
struct StudyTrial : study::PathError {
  const study::TrialRun* run;
};

/// Analysis of the errors of an experiment.
struct ErrorAnalysis : study::TaskAnalysis {
  const study::StudyRequest* request;
  std::uint64_t seed;
};

/// Experiment at a point of the file's sweep.
struct StudyPoint {
  const study::Experiment* experiment;
  const study::StudyRequest* request;
  std::size_t number;
};

namespace {

Map<std::string> words_of(const std::vector<diagram::Setting>& settings) {
  Map<std::string> words;
  for (const diagram::Setting& setting : settings)
    words.emplace_back(setting.name, without_quotes(setting.value));
  return words;
}

/// Returns a function of a simulated trial; std::nullopt for a recorded one.
template <class Get>
auto if_simulated(Get get) {
  using Value = std::remove_cvref_t<std::invoke_result_t<Get, const study::TrialRun&>>;
  return [get](const StudyTrial& of) {
    return of.run ? std::optional<Value>(std::invoke(get, *of.run)) : std::nullopt;
  };
}

std::vector<StudyTrial> trials_of(const study::Experiment& experiment) {
  std::vector<StudyTrial> trials;
  for (std::size_t i = 0; i < experiment.trials.size(); ++i)
    trials.push_back({experiment.errors.rows[i], experiment.runs.empty() ? nullptr : &experiment.runs[i]});
  return trials;
}

Map<std::vector<std::string>> orders_of(const study::Experiment& experiment,
                                        const study::StudyRequest& request) {
  Map<std::vector<std::string>> orders;
  for (const std::size_t subject : request.subjects) {
    auto& names = orders.emplace_back(std::to_string(subject), std::vector<std::string>{}).second;
    for (const std::size_t condition : study::order_of_conditions(request, experiment.seed, subject))
      names.push_back(request.conditions[condition].name);
  }
  return orders;
}

/// Returns the outcomes of each experiment by their names.
std::vector<json::Json> outcomes_of(const study::Experiment& experiment, const study::StudyRequest& request) {
  std::vector<json::Json> list;
  for (const study::ExperimentOutcome& one : study::outcomes(experiment, request)) {
    json::Json& json = list.emplace_back(json::Json::object().set("seed", one.seed));
    for (const study::NamedValue& value : one.values) json.set(value.name, value.value);
  }
  return list;
}

Map<double> means_of(const ErrorAnalysis& of) {
  Map<double> means;
  for (const study::NamedValue& mean : of.means) means.emplace_back(mean.name, mean.value);
  return means;
}

std::vector<json::Json> side_by_side(const ErrorAnalysis& of) {
  std::vector<json::Json> both;
  for (const study::SideBySide& one : study::compare(of.request->published, of, of.request->factored()))
    both.push_back(study::side_by_side_json(one));
  return both;
}

}  // namespace

static void declare(Record<StudyTrial>& is) {
  is.named("StudyTrial", "A scored trial. Units of errors are those of the study's task.");
  is.field("subject", &StudyTrial::subject, "person");
  is.field("condition", &StudyTrial::condition, "condition");
  is.field("error", &StudyTrial::error, "error of the path");
  is.field("normalised", &StudyTrial::normalised, "error over the largest one");
  is.field("raw", &StudyTrial::raw, "error before resampling");
  is.field("deviation", &StudyTrial::deviation, "error that does not depend on sampling and length");
  is.field("length", &StudyTrial::length, "length of the scored path", "m");
  is.field("duration", &StudyTrial::duration, "duration of the scored path", "s");
  is.field("points", &StudyTrial::points, "number of scored points");
  is.omitted("order", if_simulated(&study::TrialRun::order), "number among the person's trials, from 1");
  is.omitted("attempts", if_simulated(&study::TrialRun::attempts), "number of attempts");
  is.omitted("sets", if_simulated([](const study::TrialRun& of) { return words_of(of.point.own); }),
             "settings of the run");
}

static void declare(Record<ErrorAnalysis>& is) {
  is.named("StudyAnalysis", "Analysis of the errors of a study.");
  is.field("means", means_of, "mean normalised error of each condition");
  is.field(
      "anova", [](const ErrorAnalysis& of) { return study::anova_json(of.additive); },
      "analysis of variance over the factors of the conditions");
  is.field(
      "anova_with_subject", [](const ErrorAnalysis& of) { return study::anova_json(of.with_subject); },
      "the same with the subject as a factor");
  is.field(
      "repeated_measures",
      [](const ErrorAnalysis& of) {
        return of.repeated ? study::anova_json(*of.repeated) : json::Json(of.not_repeated);
      },
      "repeated measures over the factors, or the reason why there are none");
  is.field(
      "within_subjects",
      [](const ErrorAnalysis& of) {
        return of.within ? study::comparisons_json(*of.within, of.seed) : json::Json(of.not_within);
      },
      "comparisons of conditions, or the reason why there are none");
  is.field("side_by_side", side_by_side, "published values beside ours");
}

namespace {

std::optional<std::vector<json::Json>> outcomes_if_several(const StudyPoint& of) {
  if (of.experiment->others.empty()) return std::nullopt;
  return outcomes_of(*of.experiment, *of.request);
}

std::optional<ErrorAnalysis> analysis_of(const StudyPoint& of) {
  if (!of.experiment->analysis) return std::nullopt;
  return ErrorAnalysis{*of.experiment->analysis, of.request, of.experiment->seed};
}

std::optional<std::uint64_t> seed_of(const StudyPoint& of) {
  return of.experiment->runs.empty() ? std::nullopt : std::optional(of.experiment->seed);
}

std::optional<Map<std::vector<std::string>>> orders_if_simulated(const StudyPoint& of) {
  if (of.experiment->runs.empty()) return std::nullopt;
  return orders_of(*of.experiment, *of.request);
}

/// Declares a field of an experiment. `point` returns its point; std::nullopt where there is none.
template <class Struct, class Point, class Get>
void add_field(Record<Struct>& is, Point point, const char* name, Get get, const char* doc) {
  using Value = std::remove_cvref_t<std::invoke_result_t<Get, const StudyPoint&>>;
  const auto value = [point, get](const Struct& object) -> decltype(std::optional(std::declval<Value>())) {
    const std::optional<StudyPoint> of = point(object);
    if (!of) return std::nullopt;
    return get(*of);
  };
  is.omitted(name, value, doc);
}

template <class Struct, class Point>
void add_experiment(Record<Struct>& is, Point point) {
  const auto add = [&](const char* name, auto get, const char* doc) { add_field(is, point, name, get, doc); };
  using study::Experiment;
  add("rule", path(&StudyPoint::experiment, &Experiment::errors, &study::PathErrors::rule),
      "rule of scoring");
  add("remarks", path(&StudyPoint::experiment, &Experiment::remarks),
      "trials that were repeated, left out or too long");
  add(
      "trials", [](const StudyPoint& of) { return trials_of(*of.experiment); }, "trials");
  add("seed", seed_of, "seed of the experiment; missing for recorded trials");
  add("orders", orders_if_simulated, "order of the conditions of each person; missing for recorded trials");
  add("experiments", outcomes_if_several, "seed and values of each experiment; missing for a single one");
  add("analysis", analysis_of, "analysis of the errors; missing if they cannot be analysed");
}

StudyPoint point_of(const StudyReport& of, std::size_t number) {
  return {&(*of.experiments)[number], &*of.model->study, number};
}

bool is_swept(const StudyReport& of) {
  return !of.experiments->front().sets.empty();
}

std::optional<StudyPoint> only_point(const StudyReport& of) {
  return is_swept(of) ? std::nullopt : std::optional(point_of(of, 0));
}

std::optional<std::vector<StudyPoint>> points_of(const StudyReport& of) {
  if (!is_swept(of)) return std::nullopt;
  std::vector<StudyPoint> points;
  for (std::size_t i = 0; i < of.experiments->size(); ++i) points.push_back(point_of(of, i));
  return points;
}

}  // namespace

static void declare(Record<StudyPoint>& is) {
  is.named("StudyPoint", "Experiment at a point of the file's sweep.");
  is.field(
      "sets", [](const StudyPoint& of) { return words_of(of.experiment->sets); }, "swept values");
  is.field(
      "trials_file", [](const StudyPoint& of) { return io::numbered("trials", of.number, ".csv"); },
      "file of its trials");
  add_experiment(is, [](const StudyPoint& of) { return std::optional(of); });
}

void declare(Record<StudyReport>& is) {
  is.named("StudyResult", "The result of a study: study.json.");
  is.field("file", path(&StudyReport::model, &LoadedModel::file), "diagram file");
  is.field(
      "task", [](const StudyReport& of) { return of.model->study->task; }, "task");
  is.field(
      "trials_of",
      [](const StudyReport& of) {
        const std::string& trials = of.model->study->trials;
        return trials.empty() ? std::string("simulated operators") : trials;
      },
      "file of the recorded trials, or simulated operators");
  add_experiment(is, only_point);
  is.omitted("points", points_of, "points of the file's sweep, in the place of the fields of one experiment");
}

}  // namespace stepwire::session
