#include "engine/simulate/run/lane_group.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <new>

#include "engine/simulate/run/step_probe.hpp"

namespace stepwire::run {

namespace {

constexpr std::align_val_t cache_line{64};

}  // namespace

void LaneGroup::FreeAligned::operator()(double* numbers) const {
  ::operator delete(numbers, cache_line);
}

LaneGroup::Aligned LaneGroup::aligned(std::size_t count) {
  const std::size_t bytes = std::max<std::size_t>(count, 1) * sizeof(double);
  Aligned numbers(static_cast<double*>(::operator new(bytes, cache_line)));
  std::fill_n(numbers.get(), count, 0.0);
  return numbers;
}

LaneGroup::LaneGroup(const plan::CompiledLanes& code, std::vector<Run> runs)
    : code_(code),
      lanes_(static_cast<std::size_t>(code.lanes)),
      runs_(std::move(runs)),
      plan_(runs_.front().simulation->plan()),
      stopper_(plan_),
      next_check_(next_step_check(plan_, 0)),
      values_(aligned(plan_.layout.size * lanes_)),
      fits_(gather_values() && gather_numbers()) {
  make_rows();
  task_.values = values_.get();
  task_.numbers = numbers_.get();
  task_.stop = plan_.steps;
  task_.active = (1u << runs_.size()) - 1;
  task_.owner = this;
  task_.leave = [](plan::LaneTask& task, std::uint32_t lanes, int how) {
    static_cast<LaneGroup*>(task.owner)->leave(lanes, how);
  };
}

/// Interleaves the workspaces of the lanes. Returns false if the runs differ in a number that the code reads
/// as common to all lanes.
bool LaneGroup::gather_values() {
  for (std::size_t l = 0; l < lanes_; ++l) {
    const double* own = runs_[std::min(l, runs_.size() - 1)].simulation->values();
    for (std::size_t n = 0; n < plan_.layout.size; ++n) {
      values_[n * lanes_ + l] = own[n];
      const bool same = std::memcmp(own + n, values_.get() + n * lanes_, sizeof(double)) == 0;
      if (!same && !code_.differs[n]) return false;
    }
  }
  return true;
}

/// Interleaves the single numbers of the tables; the lists of each run follow after all of them.
bool LaneGroup::gather_numbers() {
  std::vector<plan::NumberTable> tables;
  for (const Run& run : runs_) {
    auto table = run.simulation->numbers(code_.variable);
    if (!table) return false;
    tables.push_back(std::move(*table));
  }
  singles_ = tables.front().singles();
  std::size_t size = singles_ * lanes_;
  for (const plan::NumberTable& table : tables) size += table.size() - singles_;
  numbers_ = aligned(size);
  std::size_t lists = singles_ * lanes_;
  for (std::size_t l = 0; l < lanes_; ++l) {
    if (l >= tables.size()) {
      for (std::size_t n = 0; n < singles_; ++n) numbers_[n * lanes_ + l] = numbers_[n * lanes_ + l - 1];
      continue;
    }
    const plan::NumberTable& table = tables[l];
    for (std::size_t n = 0; n < singles_; ++n) numbers_[n * lanes_ + l] = table.data()[n];
    for (const std::size_t place : table.list_places())
      numbers_[place * lanes_ + l] += static_cast<double>(lists) - static_cast<double>(singles_);
    std::copy(table.data() + singles_, table.data() + table.size(), numbers_.get() + lists);
    lists += table.size() - singles_;
  }
  return true;
}

void LaneGroup::make_rows() {
  std::vector<std::size_t> sizes;
  std::size_t size = 0;
  for (const record::Recorder& recorder : *runs_.front().recorders) {
    const auto rows = static_cast<std::size_t>(ticks_at_once / recorder.every() + 1);
    sizes.push_back(rows * recorder.columns() * lanes_);
    size += sizes.back();
  }
  row_memory_ = aligned(size);
  double* place = row_memory_.get();
  for (const std::size_t own : sizes) {
    first_.push_back(place);
    place += own;
  }
  next_ = first_;
  task_.rows = next_.data();
}

void LaneGroup::step(std::int64_t ticks) {
  task_.end = std::min({task_.tick + std::min(ticks, ticks_at_once), plan_.steps + 1, next_check_});
  code_.run(task_);
  write_rows();
  if (task_.active != 0 && task_.tick == next_check_) check_steps();
}

/// Checks the runs at a tick whose outputs are not computed yet, and removes those whose steps are unstable.
void LaneGroup::check_steps() {
  std::uint32_t unstable = 0;
  for (std::size_t l = 0; l < runs_.size(); ++l)
    if ((task_.active >> l & 1u) != 0 && !has_stable_steps(l)) unstable |= 1u << l;
  if (unstable != 0) remove(unstable);
  next_check_ = next_step_check(plan_, task_.tick);
}

/// True if the run also ends at this tick, since the lanes find that by themselves.
bool LaneGroup::has_stable_steps(std::size_t lane) {
  Executor& simulation = *runs_[lane].simulation;
  simulation.stand_at(task_.tick - 1, values_of(lane), true);
  simulation.evaluate();
  if (!simulation.healthy() || simulation.finished() || stopper_.stops(simulation.values())) return true;
  simulation.check_steps();
  if (simulation.healthy()) return true;
  for (record::Recorder& recorder : *runs_[lane].recorders)
    recorder.record(task_.tick, simulation.values(), false);
  return false;
}

void LaneGroup::write_rows() {
  for (std::size_t r = 0; r < first_.size(); ++r) {
    const auto numbers = static_cast<std::size_t>(next_[r] - first_[r]);
    for (std::size_t l = 0; l < runs_.size(); ++l) {
      if ((task_.active >> l & 1u) == 0) continue;
      record::Recorder& recorder = (*runs_[l].recorders)[r];
      recorder.record_rows(first_[r] + l, numbers / (recorder.columns() * lanes_), lanes_);
    }
    next_[r] = first_[r];
  }
}

void LaneGroup::leave(std::uint32_t lanes, int how) {
  write_rows();
  for (std::size_t l = 0; l < runs_.size(); ++l)
    if (lanes >> l & 1u) take_out(l, how);
  remove(lanes);
}

void LaneGroup::remove(std::uint32_t lanes) {
  task_.active &= ~lanes;
  if (task_.active == 0) return;
  const auto other = static_cast<std::size_t>(std::countr_zero(task_.active));
  for (std::size_t l = 0; l < lanes_; ++l)
    if ((task_.active >> l & 1u) == 0) copy_lane(other, l);
}

void LaneGroup::take_out(std::size_t lane, int how) {
  Executor& simulation = *runs_[lane].simulation;
  simulation.stand_at(task_.tick, values_of(lane), how == plan::LaneTask::advanced);
  if (how != plan::LaneTask::last) return;
  for (record::Recorder& recorder : *runs_[lane].recorders)
    recorder.record(task_.tick, simulation.values(), true);
  simulation.look_at_end();
}

std::vector<double> LaneGroup::values_of(std::size_t lane) const {
  std::vector<double> values(plan_.layout.size);
  for (std::size_t n = 0; n < values.size(); ++n)
    values[n] = values_[n * lanes_ + (code_.differs[n] ? lane : 0)];
  return values;
}

/// Copies the lane's own numbers. Numbers that are common to all lanes are stored in lane 0 and stay.
void LaneGroup::copy_lane(std::size_t from, std::size_t to) {
  for (std::size_t n = 0; n < plan_.layout.size; ++n)
    if (code_.differs[n]) values_[n * lanes_ + to] = values_[n * lanes_ + from];
  for (std::size_t n = 0; n < singles_; ++n) numbers_[n * lanes_ + to] = numbers_[n * lanes_ + from];
}

std::uint32_t LaneGroup::interrupt() {
  for (std::size_t l = 0; l < runs_.size(); ++l)
    if (task_.active >> l & 1u) runs_[l].simulation->stand_at(task_.tick - 1, values_of(l), true);
  return std::exchange(task_.active, 0u);
}

}  // namespace stepwire::run
