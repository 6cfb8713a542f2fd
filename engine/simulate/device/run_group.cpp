#include "engine/simulate/device/run_group.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "engine/model/plan/lane_task.hpp"
#include "engine/simulate/run/step_probe.hpp"

namespace stepwire::device {

namespace {

constexpr double row_numbers = 16e6;          // of the rows of a piece: 128 MB
constexpr std::int64_t most_ticks = 1 << 20;  // of a piece

/// Returns the count of rows of a request at the ticks [first, end).
std::int64_t rows_between(std::int64_t first, std::int64_t end, std::int64_t every) {
  return (end + every - 1) / every - (first + every - 1) / every;
}

std::size_t numbers_of_rows(const std::vector<record::Recorder>& recorders, const Piece& piece) {
  std::int64_t numbers = 0;
  for (const record::Recorder& recorder : recorders)
    numbers += piece.rows_of(recorder.every()) * static_cast<std::int64_t>(recorder.columns());
  return static_cast<std::size_t>(numbers * piece.count);
}

}  // namespace

std::size_t memory_of_run(const plan::Plan& plan, std::size_t table) {
  return (plan.layout.size + table) * sizeof(double) + sizeof(std::int32_t) + sizeof(std::int64_t);
}

RunGroup::RunGroup(Device& device, Kernel& kernel, const std::vector<plan::VariableBlock>& variable,
                   std::vector<Run> runs)
    : device_(device),
      kernel_(kernel),
      variable_(variable),
      runs_(std::move(runs)),
      plan_(runs_.front().simulation->plan()),
      stopper_(plan_),
      next_check_(run::next_step_check(plan_, 0)),
      keeps_rows_(std::ranges::any_of(*runs_.front().recorders,
                                      [](const auto& recorder) { return !recorder.keeps_last_only(); })),
      active_(runs_.size()),
      values_(plan_.layout.size * runs_.size()),
      ends_(runs_.size(), 0),
      ends_before_(ends_),
      ticks_(runs_.size(), 0),
      fits_(gather()) {
  if (fits_) allocate();
}

/// Gathers the numbers of the runs. Returns false if the kernel has one of them as a constant. Lists may have
/// other lengths from run to run, so shorter tables end with zeros.
bool RunGroup::gather() {
  std::vector<plan::NumberTable> tables;
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    const double* own = runs_[r].simulation->values();
    for (std::size_t n = 0; n < plan_.layout.size; ++n) values_[n * runs_.size() + r] = own[n];
    auto table = runs_[r].simulation->numbers(variable_);
    if (!table) return false;
    table_ = std::max(table_, table->size());
    tables.push_back(std::move(*table));
  }
  numbers_.resize(table_ * runs_.size());
  for (std::size_t r = 0; r < tables.size(); ++r)
    std::copy_n(tables[r].data(), tables[r].size(), numbers_.data() + r * table_);
  return true;
}

void RunGroup::allocate() {
  std::size_t rows = 0;
  Piece longest{};
  longest.end = ticks_of_rows();
  longest.count = static_cast<std::int64_t>(runs_.size());
  if (keeps_rows_) rows = numbers_of_rows(*runs_.front().recorders, longest);
  memory_ = std::unique_ptr<Memory>(new Memory{{device_, values_.size()},
                                               {device_, numbers_.size()},
                                               {device_, rows},
                                               {device_, runs_.size()},
                                               {device_, runs_.size()}});
  rows_.resize(rows);
  memory_->values.write(values_.data());
  memory_->numbers.write(numbers_.data());
  memory_->ends.write(ends_.data());
}

/// Returns the largest count of ticks whose rows fit into the memory for them; at least one.
std::int64_t RunGroup::ticks_of_rows() const {
  if (!keeps_rows_) return most_ticks;
  double of_a_tick = 0.0, of_first = 0.0;
  for (const record::Recorder& recorder : *runs_.front().recorders) {
    of_first += static_cast<double>(recorder.columns());
    of_a_tick += static_cast<double>(recorder.columns()) / static_cast<double>(recorder.every());
  }
  const auto count = static_cast<double>(runs_.size());
  if (of_a_tick == 0.0) return most_ticks;
  return std::clamp(static_cast<std::int64_t>((row_numbers / count - of_first) / of_a_tick), std::int64_t{1},
                    most_ticks);
}

void RunGroup::step() {
  using Clock = std::chrono::steady_clock;
  const std::int64_t end =
      std::min({tick_ + std::min(length_, ticks_of_rows()), plan_.steps + 1, next_check_});
  const Piece piece{memory_->values.data(),
                    memory_->numbers.data(),
                    memory_->ends.data(),
                    memory_->ticks.data(),
                    keeps_rows_ ? memory_->rows.data() : nullptr,
                    tick_,
                    end,
                    plan_.steps,
                    static_cast<std::int64_t>(runs_.size()),
                    static_cast<std::int64_t>(table_)};
  const auto start = Clock::now();
  kernel_.step(piece);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  read_ends();
  if (keeps_rows_) write_rows(piece);
  tick_ = end;
  if (seconds < 0.25 * longest_piece) length_ = std::min(2 * length_, most_ticks);
  if (seconds > longest_piece) length_ = std::max<std::int64_t>(length_ / 2, 1);
  if (goes_on() && tick_ == next_check_) check_steps();
}

void RunGroup::read_ends() {
  ends_before_ = ends_;
  memory_->ends.read(ends_.data());
  active_ = static_cast<std::size_t>(std::ranges::count(ends_, 0));
  memory_->ticks.read(ticks_.data());
}

/// Records the rows of a piece, of each run up to its end.
void RunGroup::write_rows(const Piece& piece) {
  memory_->rows.read(rows_.data(), numbers_of_rows(*runs_.front().recorders, piece));
  const double* first = rows_.data();
  for (std::size_t request = 0; request < runs_.front().recorders->size(); ++request) {
    const record::Recorder& form = (*runs_.front().recorders)[request];
    for (std::size_t r = 0; r < runs_.size(); ++r) {
      if (ends_before_[r] != 0) continue;
      const bool has_row = ends_[r] == 1 + plan::LaneTask::advanced;  // of the tick at which it has ended
      const std::int64_t end = ends_[r] == 0 ? piece.end : has_row ? ticks_[r] + 1 : ticks_[r];
      const std::int64_t rows = rows_between(piece.tick, end, form.every());
      (*runs_[r].recorders)[request].record_rows(first + r, static_cast<std::size_t>(rows), runs_.size());
    }
    first += piece.rows_of(form.every()) * static_cast<std::int64_t>(form.columns()) * piece.count;
  }
}

/// Checks the active runs at a tick whose outputs are not computed yet, and takes those out whose steps are
/// unstable.
void RunGroup::check_steps() {
  memory_->values.read(values_.data());
  bool changed = false;
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    if (ends_[r] != 0 || has_stable_steps(r)) continue;
    ends_[r] = taken_out;
    --active_;
    changed = true;
  }
  if (changed) memory_->ends.write(ends_.data());
  next_check_ = run::next_step_check(plan_, tick_);
}

/// True if the run also ends at this tick, since the device finds that by itself.
bool RunGroup::has_stable_steps(std::size_t run) {
  run::Executor& simulation = *runs_[run].simulation;
  simulation.stand_at(tick_ - 1, values_of(run), true);
  simulation.evaluate();
  const bool ends = !simulation.healthy() || simulation.finished() || simulation.has_stopped() ||
                    stopper_.stops(simulation.values());
  if (ends) return true;
  simulation.check_steps();
  if (simulation.healthy()) return true;
  for (record::Recorder& recorder : *runs_[run].recorders) recorder.record(tick_, simulation.values(), false);
  return false;
}

std::vector<bool> RunGroup::finish() {
  memory_->values.read(values_.data());
  std::vector<bool> active(runs_.size(), false);
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    active[r] = ends_[r] == 0;
    if (ends_[r] != taken_out) take_out(r);
  }
  return active;
}

void RunGroup::take_out(std::size_t run) {
  run::Executor& simulation = *runs_[run].simulation;
  const std::int32_t how = ends_[run] - 1;
  if (how < 0) return simulation.stand_at(tick_ - 1, values_of(run), true);
  simulation.stand_at(ticks_[run], values_of(run), how == plan::LaneTask::advanced);
  if (how != plan::LaneTask::last && !simulation.has_stopped_between()) return;
  const std::int64_t before = ticks_[run] - 1;
  const bool ended_there = simulation.has_stopped() && simulation.time() == plan_.time_of(before);
  for (record::Recorder& recorder : *runs_[run].recorders) {
    if (ended_there) recorder.go_back_to(before);
    recorder.record(ticks_[run], simulation.values(), true);
  }
  simulation.look_at_end();
}

std::vector<double> RunGroup::values_of(std::size_t run) const {
  std::vector<double> values(plan_.layout.size);
  for (std::size_t n = 0; n < values.size(); ++n) values[n] = values_[n * runs_.size() + run];
  return values;
}

}  // namespace stepwire::device
