#include "engine/app/session/run_result.hpp"

#include "engine/app/session/sweep_sections.hpp"
#include "engine/app/session/version.hpp"
#include "engine/model/diagram/uses.hpp"
#include "engine/simulate/run/pooling.hpp"

namespace stepwire::session {

using result::Map;
using result::Record;

std::vector<JudgedClaim> judged_claims(const LoadedModel& model, const Outcome& outcome) {
  std::vector<JudgedClaim> claims;
  for (const claim::Verdict& verdict : outcome.verdicts)
    claims.push_back({verdict, model.file, model.job.plan.diagram.reproduces.figure});
  return claims;
}

namespace {

std::optional<bool> is_invariant(const JudgedClaim& claim) {
  return claim.kind == claim::Claim::Kind::invariant ? std::optional(true) : std::nullopt;
}

std::optional<std::array<double, 2>> interval_of(const JudgedClaim& claim) {
  if (!claim.interval) return std::nullopt;
  return std::array{claim.interval->low, claim.interval->high};
}

std::optional<double> confidence_of(const JudgedClaim& claim) {
  return claim.interval ? std::optional(claim.confidence) : std::nullopt;
}

/// Returns a function of a text member that is std::nullopt where the text is empty.
template <class Struct>
auto text_of(std::string Struct::*member) {
  return [member](const Struct& of) { return result::text_if_any(of.*member); };
}

}  // namespace

void declare(Record<JudgedClaim>& is) {
  is.named("Claim", "A claim of the file, judged: an entry of claims.json.");
  is.field("file", &JudgedClaim::file, "diagram file");
  is.field("figure", &JudgedClaim::figure, "figure of a publication that the file reproduces; null without");
  is.field("that", &JudgedClaim::that, "statement");
  is.field("check", &JudgedClaim::check, "condition");
  is.field("value", &JudgedClaim::value,
           "value, of `like` the largest difference divided by its tolerance; null if it is infinite or "
           "could not be judged",
           "SI");
  is.field("holds", &JudgedClaim::holds, "true if it holds");
  is.omitted("invariant", is_invariant, "true for an invariant");
  is.omitted("disagrees", text_of(&claim::Verdict::disagrees), "reason in the file for a known failure");
  is.omitted("interval", interval_of, "confidence interval of a reduction over several runs", "SI");
  is.omitted("confidence", confidence_of, "confidence of the interval");
  is.omitted("worst", text_of(&claim::Verdict::worst), "settings of the run that gave the value");
  is.omitted("note", text_of(&claim::Verdict::note), "reason why it could not be judged");
  is.hidden("shown", &JudgedClaim::shown, "value with its unit");
  is.hidden("fails", &JudgedClaim::fails, "true if it fails and the file does not expect that");
}

void declare(Record<AlgebraicLoop>& is) {
  is.named("AlgebraicLoop", "Cost of an algebraic loop.");
  is.field("loop", &AlgebraicLoop::path, "blocks of the loop");
  is.field("unknowns", &AlgebraicLoop::unknowns, "numbers at which the loop is torn");
  is.field("instants", &AlgebraicLoop::instants, "ticks and stages at which it was solved");
  is.field("iterations", &AlgebraicLoop::iterations, "passes through its blocks");
  is.field("max_iterations", &AlgebraicLoop::most, "largest number of passes at an instant");
  is.field("unsolved", &AlgebraicLoop::unsolved, "instants without a solution");
  is.field(
      "first_unsolved",
      [](const AlgebraicLoop& of) {
        return of.unsolved > 0 ? std::optional(of.first_unsolved) : std::nullopt;
      },
      "time of the first of them", "s");
}

/// Repository of git whose files are parts.
struct RunRepository : diagram::Use {};

/// Axis of a sweep. Words are in the order in which a MAT file numbers them from 0.
struct AxisValues {
  std::string parameter;
  std::size_t count = 0;
  std::vector<std::string> values{};
};

/// Parameter of the file with its value in a run.
struct RunParameter : diagram::DiagramParameter {};

/// Steps of an adaptive solver.
struct SolverSteps : run::StepCount {
  diagram::ErrorControl control;
  bool chooses;  ///< the solver chooses the method
};

/// Lanes of a sweep.
struct LanesOf {
  int count;
  std::int64_t ticks;
  std::string why_not;
};

/// Device of a sweep.
struct DeviceOf : run::DeviceReport {};

/// Located events of a run.
struct LocatedEvents : run::EventCount {};

/// Sentence that a block raised.
struct RaisedNotice : run::RaisedDiagnostic {};

static void declare(Record<AxisValues>& is) {
  is.named("SweepAxis", "An axis of a sweep.");
  is.field("parameter", &AxisValues::parameter, "swept parameter");
  is.field("count", &AxisValues::count, "number of values");
  is.field("values", &AxisValues::values, "values; empty for more than 10,000, which sweep.csv has");
}

static void declare(Record<RunRepository>& is) {
  is.named("UsedRepository", "A repository whose files are parts: an entry of `uses`.");
  is.field("name", &RunRepository::name, "name in the file");
  is.field("git", &RunRepository::git, "address");
  is.field("rev", &RunRepository::rev, "commit");
  is.field("sha256", &RunRepository::sha256, "hash of its files");
}

/// Returns a number, a list, the rows of a matrix, or the text of another value.
static json::Json value_of(const diagram::DiagramParameter& of) {
  if (const double* number = std::get_if<double>(&of.value.content)) return json::Json(*number);
  if (const auto* vector = std::get_if<Eigen::VectorXd>(&of.value.content))
    return json::Json::list_of(*vector);
  const auto* matrix = std::get_if<Eigen::MatrixXd>(&of.value.content);
  if (!matrix) return json::Json(of.text);
  json::Json rows = json::Json::list();
  for (const auto& row : matrix->rowwise()) rows.push(json::Json::list_of(Eigen::VectorXd(row.transpose())));
  return rows;
}

static json::Json units_of(const diagram::DiagramParameter& of) {
  json::Json units = json::Json::list();
  for (const auto& unit : of.each) units.push(unit ? json::Json(unit::si_name(*unit)) : json::Json());
  return units;
}

static void declare(Record<RunParameter>& is) {
  is.named("RunParameter", "A parameter of the file.");
  is.field("name", &RunParameter::name, "name");
  is.field(
      "value", [](const RunParameter& of) { return value_of(of); },
      "number, list of numbers, or rows of a matrix, in SI; or text");
  is.field("unit", &RunParameter::dimension, "SI unit; null if unknown, or if the elements have several");
  is.field(
      "units", [](const RunParameter& of) { return units_of(of); },
      "SI units of the elements, null without one, a matrix column by column; empty for one common unit");
  is.field("written", &RunParameter::text, "value as written or set");
  is.field("assumed", &RunParameter::assumed, "true if the file marks it as assumed");
  is.field("set", &RunParameter::set, "true if the call sets it");
}

static void declare(Record<SolverSteps>& is) {
  is.named("SolverSteps", "Steps of a solver with error control.");
  is.field("relative", result::path(&SolverSteps::control, &diagram::ErrorControl::relative),
           "relative tolerance");
  is.field("absolute", result::path(&SolverSteps::control, &diagram::ErrorControl::absolute),
           "absolute tolerance", "SI");
  is.field("accepted", &SolverSteps::accepted, "accepted steps");
  is.field("rejected", &SolverSteps::rejected, "rejected steps");
  is.field("largest_error", &SolverSteps::largest_error, "of the accepted steps, relative to the tolerance");
  is.field(
      "stiff", [](const SolverSteps& of) { return of.chooses ? std::optional(of.stiff) : std::nullopt; },
      "true if 'auto' has switched to the stiff method; null for another solver");
}

static void declare(Record<LanesOf>& is) {
  is.named("Lanes", "Runs that were stepped together.");
  is.field("count", &LanesOf::count, "number of lanes");
  is.field("ticks", &LanesOf::ticks, "ticks in lanes");
  is.field("why_not", text_of(&LanesOf::why_not), "reason for runs without lanes");
}

static void declare(Record<DeviceOf>& is) {
  is.named("SweepDevice", "Runs of a sweep that a GPU has made.");
  is.field("name", text_of(&DeviceOf::name), "name of the GPU; null if it has made none");
  is.field("runs", &DeviceOf::runs, "number of runs that it has made");
  is.field("why_not", text_of(&DeviceOf::why_not), "reason for runs on the processor");
}

static void declare(Record<LocatedEvents>& is) {
  is.named("LocatedEvents", "Events that were located between ticks.");
  is.field("located", &LocatedEvents::located, "number of events");
  is.field("most_in_a_step", &LocatedEvents::most_in_a_step, "largest number in a step");
}

static void declare(Record<RaisedNotice>& is) {
  is.named("Notice", "A sentence that a block raised during the run.");
  is.field("block", &RaisedNotice::block, "block");
  is.field("time", &RaisedNotice::time, "first time", "s");
  is.field("text", &RaisedNotice::text, "sentence");
}

namespace {

constexpr std::size_t max_listed = 10'000;  // Longest list of values of an axis; sweep.csv has all values.

const run::Job& job_of(const RunReport& of) {
  return of.model->job;
}

const diagram::Diagram& diagram_of(const RunReport& of) {
  return of.model->job.plan.diagram;
}

const run::RunResult& result_of(const RunReport& of) {
  return of.outcome->result;
}

std::optional<std::vector<AxisValues>> sweep_of(const RunReport& of) {
  if (job_of(of).points.empty()) return {};
  std::vector<AxisValues> axes;
  for (const diagram::Sweep::Axis& axis : diagram_of(of).sweep->axes) {
    const auto words = run::has_words(axis) ? run::words_of(axis) : std::vector<std::string>{};
    AxisValues& values = axes.emplace_back(axis.parameter, words.empty() ? axis.count() : words.size());
    for (std::size_t i = 0; values.count <= max_listed && i < values.count; ++i)
      values.values.push_back(without_quotes(words.empty() ? axis.text(i) : words[i]));
  }
  return axes;
}

std::optional<std::string> keep_of(const RunReport& of) {
  if (of.model->kept) return "numbers";
  const auto& sweep = diagram_of(of).sweep;
  if (job_of(of).points.empty() || !sweep) return {};
  return sweep->keep == diagram::Sweep::Keep::final ? "final" : "rows";
}

std::optional<Map<std::string>> kept_of(const RunReport& of) {
  if (!of.model->kept) return {};
  Map<std::string> texts;
  for (const yaml::Entry& entry : diagram_of(of).sweep->kept.entries)
    texts.emplace_back(entry.key, entry.value.text);
  return texts;
}

std::optional<std::vector<std::size_t>> recorded_runs(const RunReport& of) {
  if (!of.model->kept || recordings_of(*of.model) == 1) return {};
  std::vector<std::size_t> runs;
  for (const std::size_t point : diagram_of(of).sweep->recorded_points()) runs.push_back(point + 1);
  return runs;
}

std::optional<LanesOf> lanes_of(const RunReport& of) {
  if (job_of(of).points.empty()) return {};
  const run::RunResult& result = result_of(of);
  return LanesOf{result.lanes.count, result.lane_ticks, result.lanes.why_not};
}

std::optional<DeviceOf> device_of(const RunReport& of) {
  const run::DeviceReport& device = result_of(of).lanes.device;
  if (device.name.empty() && device.why_not.empty()) return {};
  return DeviceOf{device};
}

std::optional<SolverSteps> steps_of(const RunReport& of) {
  const diagram::Diagram& diagram = diagram_of(of);
  if (!diagram.error_control) return {};
  return SolverSteps{result_of(of).steps, *diagram.error_control, diagram.solver == "auto"};
}

std::optional<LocatedEvents> events_of(const RunReport& of) {
  if (!diagram_of(of).events.locate) return {};
  return LocatedEvents{result_of(of).events};
}

std::vector<std::string> fault_texts(const RunReport& of) {
  std::vector<std::string> faults;
  for (const run::RunFault& fault : result_of(of).faults) faults.push_back(fault.fault.text());
  return faults;
}

/// Adds the head of the file as it was run.
void add_head(Record<RunReport>& is) {
  using diagram::Diagram;
  is.field("file", result::path(&RunReport::model, &LoadedModel::file), "diagram file");
  is.field("title", result::path(diagram_of, &Diagram::title), "title");
  is.field("hash", result::path(&RunReport::model, &LoadedModel::hash), "hash of the diagram and its data");
  is.field(
      "uses",
      [](const RunReport& of) {
        return result::as<RunRepository>(diagram::used_repositories(diagram_of(of)));
      },
      "repositories whose files are parts");
  is.field(
      "parameters", [](const RunReport& of) { return result::as<RunParameter>(diagram_of(of).parameters); },
      "parameters of the file");
  is.field("step", result::path(diagram_of, &Diagram::step), "step", "s");
  is.field("stop", result::path(diagram_of, &Diagram::stop), "end", "s");
  is.field(
      "solver", [](const RunReport& of) { return result::text_if_any(diagram_of(of).solver); },
      "solver; null if the file names none");
  is.field(
      "functions", [](const RunReport& of) { return diagram_of(of).uses_libm ? "libm" : "portable"; },
      "source of functions such as sin: portable or libm");
}

void add_work(Record<RunReport>& is) {
  is.field("sweep", sweep_of, "axes of the sweep; null for a single run");
  is.field("keep", keep_of, "kind of data that a sweep keeps: rows, final or numbers");
  is.field("kept", kept_of, "expressions of the kept numbers; null without");
  is.field("recorded_runs", recorded_runs, "runs whose rows are kept beside the numbers, from 1");
  is.field(
      "runs", [](const RunReport& of) { return std::max<std::size_t>(1, job_of(of).points.size()); },
      "number of runs");
  is.field("ticks", result::path(result_of, &run::RunResult::ticks), "ticks of all runs");
  is.field("compiled_ticks", result::path(result_of, &run::RunResult::compiled_ticks),
           "ticks in compiled code");
  is.field("lanes", lanes_of, "runs that were stepped together; null for a single run");
  is.field("device", device_of, "runs that a GPU has made; null without `--device gpu` or `auto`");
  is.field(
      "blocks", [](const RunReport& of) { return diagram_of(of).blocks.size(); }, "number of blocks");
  is.field("block_folders", result::path(&RunReport::model, &LoadedModel::blocksets),
           "folders of external blocks");
}

}  // namespace

void declare(Record<RunReport>& is) {
  is.named("RunResult", "The result of a run or a sweep: run.json.");
  add_head(is);
  add_work(is);
  is.field(
      "algebraic_loops", [](const RunReport& of) { return result::as<AlgebraicLoop>(result_of(of).loops); },
      "costs of algebraic loops");
  is.field("solver_steps", steps_of, "steps of the solver; null without error control");
  is.field("events", events_of, "located events; null without event location");
  is.field(
      "notices", [](const RunReport& of) { return result::as<RaisedNotice>(result_of(of).diagnostics); },
      "sentences that blocks raised");
  is.field(
      "findings", [](const RunReport& of) { return findings_of(*of.model, *of.outcome); },
      "sentences on the figures");
  is.field("faults", fault_texts, "faults that ended runs early");
  is.field("interrupted", result::path(result_of, &run::RunResult::interrupted),
           "true if it was interrupted");
  is.field(
      "version", [](const RunReport&) { return program_version(); }, "version of the program");
  is.field(
      "compiler", [](const RunReport&) { return compiler_version(); }, "compiler of the program");
  is.field("duration", result::path(&RunReport::outcome, &Outcome::seconds), "duration of the run", "s");
}

}  // namespace stepwire::session
