#include "engine/app/session/ordered_points.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/claim/judge.hpp"
#include "engine/app/session/run_views.hpp"
#include "engine/app/session/sweep_sections.hpp"
#include "engine/simulate/run/memory.hpp"
#include "engine/simulate/run/row_per_run.hpp"
#include "engine/view/plot/last_rows.hpp"
#include "engine/view/scene/scene_states.hpp"

namespace stepwire::session {
namespace {

/// Part of a file or call that needs the rows of all runs at once, with an alternative that does not.
struct Need {
  yaml::Place place;
  std::string subject, what, cure;
};

bool keeps_rows(const LoadedModel& model) {
  const auto& sweep = model.job.plan.diagram.sweep;
  return !model.job.points.empty() && !model.study && !model.kept &&
         sweep->keep == diagram::Sweep::Keep::rows;
}

void add_claims(const LoadedModel& model, std::vector<Need>& needs) {
  for (const claim::Claim& claim : model.claims)
    if (claim.recording < recordings_of(model) && claim::keeps_rows(claim))
      needs.push_back(
          {claim.place, "claims", fmt::format("'{}'", claim.check),
           "judge a number of each run, by 'each_run: true', 'quantile_of_runs' or 'fraction_of_runs'"});
}

void add_pictures(const LoadedModel& model, std::vector<Need>& needs) {
  const diagram::Diagram& diagram = model.job.plan.diagram;
  const std::string numbers =
      "draw numbers of the runs, which 'sweep: {keep: {peak: max(x)}}' makes, or their last rows ('rows: "
      "final')";
  const yaml::Node& figures = diagram.figure;
  for (std::size_t i = 0; i < model.figures.size(); ++i) {
    const bool reads = std::ranges::any_of(model.figures[i].panels, [&](const plot::Panel& panel) {
      return plot::rows_read(panel, recordings_of(model)) == plot::RowsRead::all;
    });
    if (reads)
      needs.push_back({{diagram.file, figures.is_list() ? figures.items[i].mark : figures.mark},
                       "figure",
                       "the picture",
                       numbers});
  }
  if (model.scene) needs.push_back({{diagram.file, diagram.scene.mark}, "scene", "its animation", numbers});
}

void add_tables(const LoadedModel& model, const RowUse& use, std::vector<Need>& needs) {
  const yaml::Place place{model.file, {}};
  const bool are_runs = use.folder.empty() || std::ranges::all_of(use.files, has_runs);
  if (!are_runs) needs.push_back({place, "--files", "a table of kind csv or mat", "give --files h5"});
  if (use.table) needs.push_back({place, "--csv", "a table", "give --out DIR --files h5"});
}

std::vector<Need> needs_of(const LoadedModel& model, const RowUse& use) {
  std::vector<Need> needs;
  add_claims(model, needs);
  if (!use.folder.empty()) add_pictures(model, needs);
  add_tables(model, use, needs);
  return needs;
}

/// Appends the rows of a run from row `first` on.
void append_rows(record::Recording& all, const record::Recording& run, std::size_t first) {
  all.starts.push_back(all.table.rows());
  for (std::size_t i = 0; i < run.table.columns.size(); ++i) {
    const std::vector<double>& values = run.table.columns[i].values;
    all.table.columns[i].values.insert(all.table.columns[i].values.end(),
                                       values.begin() + static_cast<std::ptrdiff_t>(first), values.end());
  }
}

/// Returns an estimate of the memory of a result.
std::size_t bytes_of(const run::PointResult& result) {
  constexpr std::size_t of_a_result = 1024;
  std::size_t bytes = sizeof result + of_a_result;
  for (const record::Recording& recording : result.recordings)
    for (const table::Column& column : recording.table.columns)
      bytes += sizeof column + column.values.capacity() * sizeof(double);
  return bytes;
}

}  // namespace

bool goes_run_by_run(const LoadedModel& model, const RowUse& use) {
  return keeps_rows(model) && needs_of(model, use).empty();
}

void require_rows(const LoadedModel& model, const RowUse& use) {
  if (!keeps_rows(model)) return;
  const auto lack = run::lack_for_all_rows(model.job);
  if (!lack) return;
  yaml::Faults faults;
  for (const Need& need : needs_of(model, use))
    faults.add({need.place,
                need.subject,
                yaml::Message(fmt::format("{} needs the rows of all runs at once, and {}", need.what, *lack),
                              fmt::format("{}, or give 'record' an 'every'", need.cure)),
                {}});
  faults.throw_if_any();
}

void DrawnRows::add(const std::vector<record::Recording>& run) {
  if (rows_.empty()) {
    rows_ = run;
    for (record::Recording& recording : rows_) {
      recording.starts.clear();
      for (table::Column& column : recording.table.columns) column.values.clear();
    }
  }
  for (std::size_t r = 0; r < run.size(); ++r) append_rows(rows_[r], run[r], first_drawn(run, r));
}

std::size_t DrawnRows::first_drawn(const std::vector<record::Recording>& run, std::size_t recording) const {
  std::size_t first = run[recording].table.rows();
  for (const plot::Figure& figure : model_.figures)
    for (const plot::Panel& panel : figure.panels)
      if (plot::rows_read(panel, run.size()) == plot::RowsRead::last &&
          std::ranges::find(panel.recordings, recording) != panel.recordings.end())
        first = std::min(first, plot::first_drawn_row(panel, run, recording));
  return first;
}

StreamingJudge::StreamingJudge(const LoadedModel& model, const RowUse& use)
    : model_(model),
      swept_(model.job),
      ends_(model.job),
      judges_(model),
      drawn_(model),
      draws_(!use.folder.empty()) {
  const diagram::Diagram& diagram = model.job.plan.diagram;
  files_.resize(diagram.records.size());
  for (std::size_t r = 0; r < files_.size() && draws_; ++r)
    for (const FileKind kind : use.files)
      files_[r].push_back(open_run_file(signals_path(use.folder, kind, r), kind, diagram.title));
}

void StreamingJudge::add(run::PointResult result) {
  pass_missing(result.point);
  for (record::Recording& recording : result.recordings) swept_.add(recording, result.point);
  ends_.add(result.point, std::move(result.end));
  pass(std::move(result.recordings));
}

void StreamingJudge::pass(std::vector<record::Recording> run) {
  for (std::size_t r = 0; r < files_.size(); ++r) {
    if (files_[r].empty()) continue;
    const table::RunView view = RunViews(model_, run[r], next_).view(0);
    for (const auto& file : files_[r]) file->add(view);
  }
  ++next_;
  if (model_.scene) scene::add_scene_states(*model_.scene, run);
  judges_.add(run);
  if (draws_) drawn_.add(run);
}

void StreamingJudge::pass_missing(std::size_t end) {
  while (next_ < end) {
    misses_ = true;
    auto run = run::empty_recordings(model_.job.plan_of(next_), nullptr);
    for (record::Recording& recording : run) swept_.add(recording, next_);
    pass(std::move(run));
  }
}

Outcome StreamingJudge::take() {
  pass_missing(model_.job.points.size());
  for (const auto& files : files_)
    for (const auto& file : files) file->finish();
  Outcome outcome;
  static_cast<run::RunEnd&>(outcome.result) = ends_.take();
  outcome.result.interrupted = outcome.result.interrupted || misses_;
  outcome.result.recordings = drawn_.take();
  outcome.rows_passed = true;
  judges_.judge(outcome);
  return outcome;
}

std::optional<std::size_t> OrderedPoints::next() {
  const std::lock_guard lock(mutex_);
  return named_ < points_ ? std::optional(named_++) : std::nullopt;
}

void OrderedPoints::wait_for_room(std::optional<std::size_t> held) {
  std::unique_lock lock(mutex_);
  moved_.wait(lock, [&] { return left_ || bytes_ <= most_waiting_ || held == next_; });
}

void OrderedPoints::leave() {
  const std::lock_guard lock(mutex_);
  left_ = true;
  moved_.notify_all();
}

void OrderedPoints::take(run::PointResult result) {
  const std::lock_guard lock(mutex_);
  ++taken_;
  bytes_ += bytes_of(result);
  waiting_.emplace(result.point, std::move(result));
  for (auto first = waiting_.find(next_); first != waiting_.end(); first = waiting_.find(++next_)) {
    bytes_ -= bytes_of(first->second);
    passed_.add(std::move(first->second));
    waiting_.erase(first);
  }
  peak_ = std::max(peak_, bytes_);
  moved_.notify_all();
}

double OrderedPoints::done() const {
  return static_cast<double>(taken_) / static_cast<double>(points_);
}

std::size_t OrderedPoints::peak() const {
  const std::lock_guard lock(mutex_);
  return peak_;
}

Outcome OrderedPoints::outcome() {
  for (auto& [point, result] : waiting_) passed_.add(std::move(result));
  return passed_.take();
}

}  // namespace stepwire::session
