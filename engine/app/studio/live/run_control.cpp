#include "engine/app/studio/live/run_control.hpp"

#include <algorithm>
#include <utility>

namespace stepwire::live {

namespace {

constexpr std::size_t rows_at_once = 256, rows_at_most = 16'384;
constexpr std::size_t part = 4096;  // ticks of the past per evaluation

constexpr double late = 0.02, lost = 0.2, measure = 0.5;  // [s]

}  // namespace

RowGathering::RowGathering(const SignalList& signals, double step, const StoreOptions& options)
    : signals_(signals), store_(step, options) {
  for (std::size_t i = 0; i < signals.all().size(); ++i)
    if (signals.all()[i].recorded) column(i, 0);
  if (columns_.empty() && !signals.all().empty()) column(0, 0);  // the row count of the store is the tick
}

std::size_t RowGathering::add(std::size_t offset, std::int64_t tick) {
  flush();
  columns_.push_back({offset});
  return store_.add(tick);
}

std::size_t RowGathering::column(std::size_t signal, std::int64_t next_tick) {
  const std::size_t offset = signals_.all().at(signal).offset;
  const auto known = of_offset_.find(offset);
  if (known != of_offset_.end()) return known->second;
  const std::size_t column = add(offset, next_tick);
  of_offset_.emplace(offset, column);
  return column;
}

std::size_t RowGathering::column(const query::Formula& formula, std::int64_t next_tick) {
  const auto known = of_formula_.find(formula.text);
  if (known != of_formula_.end()) return known->second;
  std::vector<std::size_t> places;
  std::int64_t from = 0;
  for (const std::string& name : formula.columns) {
    const auto signal = signals_.find(name);
    places.push_back(signal ? signals_.all()[*signal].offset : plan::Layout::time);
    if (signal) from = std::max(from, store_.first_tick(column(*signal, next_tick)));
  }
  const std::size_t added = add(0, from);
  columns_.back().formula = formula.expression;
  columns_.back().places = std::move(places);
  of_formula_.emplace(formula.text, added);
  fill(added, from, next_tick);
  return added;
}

/// Computes a formula for past ticks.
void RowGathering::fill(std::size_t index, std::int64_t from, std::int64_t to) {
  const Column& column = columns_[index];
  std::vector<std::vector<double>> values(column.places.size());
  std::vector<double> row(column.places.size()), result;
  for (std::int64_t first = from; first < to; first += part) {
    const auto count = static_cast<std::size_t>(std::min<std::int64_t>(part, to - first));
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i].resize(count);
      if (column.places[i] != plan::Layout::time)
        store_.read(of_offset_.at(column.places[i]), first, values[i]);
      for (std::size_t k = 0; column.places[i] == plan::Layout::time && k < count; ++k)
        values[i][k] = store_.time_of(first + static_cast<std::int64_t>(k));
    }
    result.clear();
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t i = 0; i < row.size(); ++i) row[i] = values[i][k];
      result.push_back((*column.formula)(row));
    }
    store_.append_to(index, result);
  }
}

std::vector<std::size_t> RowGathering::places() const {
  std::vector<std::size_t> all;
  for (const Column& column : columns_)
    if (column.formula)
      all.insert(all.end(), column.places.begin(), column.places.end());
    else
      all.push_back(column.offset);
  return all;
}

void RowGathering::take(const double* values) {
  for (const Column& column : columns_) rows_.push_back(column(values));
  const std::size_t count = rows_.size() / std::max<std::size_t>(columns_.size(), 1);
  if (count < rows_at_once || count % rows_at_once != 0) return;
  if (count >= rows_at_most) return flush();
  if (store_.try_append(rows_)) rows_.clear();
}

void RowGathering::flush() {
  std::vector<double> rows;
  rows.swap(rows_);
  if (!rows.empty()) store_.append(rows);
  rows.clear();
  rows_.swap(rows);  // reuses the memory
}

std::vector<RowGathering::Incomplete> RowGathering::incomplete() const {
  std::vector<Incomplete> found;
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (const std::int64_t first = store_.first_tick(i); first > 0) found.push_back({i, first, columns_[i]});
  return found;
}

void RowGathering::cut(std::int64_t tick) {
  flush();
  store_.cut(tick);
}

void Pace::begin(double rate, std::int64_t tick, double now) {
  rate_ = rate;
  start_ = marked_ = now;
  first_ = marked_tick_ = tick;
  measured_ = rate;
}

void Pace::begun(std::int64_t tick, double now) {
  if (now - marked_ > measure) {
    measured_ = static_cast<double>(tick - marked_tick_) * step_ / (now - marked_);
    marked_ = now;
    marked_tick_ = tick;
  }
  if (rate_ <= 0.0) return;
  const double behind = now - due(tick, now);
  if (behind > late) ++missed_;
  if (behind <= lost) return;
  start_ = now;
  first_ = tick;
}

RunControl::RunControl(const plan::Plan& plan, const SignalList& signals, const StoreOptions& store,
                       std::uint32_t run, std::function<void()> changed)
    : plan_(plan),
      rows_(signals, plan.diagram.step, store),
      inputs_(plan),
      pace_(plan.diagram.step),
      lives_(run),
      changed_(std::move(changed)) {
  status_.run = run;
}

SetResult RunControl::set(const std::string& name, const std::string& text) {
  return commands_.ask([&] {
    LiveEvent event{next_tick(), name, text, {}, 0.0};
    event.tick = apply_now(event);
    const std::int64_t tick = std::max<std::int64_t>(event.tick, 0);
    log_.add(std::move(event));
    return SetResult{present_number(executor(), name, text), text, tick};
  });
}

RunStatus RunControl::status() const {
  const std::lock_guard lock(status_mutex_);
  return status_;
}

EventLog RunControl::log() {
  return commands_.ask([&] {
    take_rows();
    return log_;
  });
}

std::optional<double> RunControl::value(const std::string& parameter) {
  return commands_.ask([&] { return present_number(executor(), parameter, ""); });
}

void RunControl::tell() {
  {
    const std::lock_guard lock(status_mutex_);
    describe(status_);
    status_.run = lives_;
    status_.tick = std::max<std::int64_t>(shown_, 0);
    status_.time = plan_.time_of(status_.tick);
    status_.rate = status_.state == RunStatus::State::playing ? pace_.measured() : 0.0;
    status_.wanted = pace_.rate();
  }
  if (changed_) changed_();
}

void RunControl::begin_log(const std::function<void(const LiveEvent&)>& apply) {
  const std::vector<LiveEvent> set = log_.last_of_each();
  log_ = {};
  for (LiveEvent event : set) {
    if (event.is_input()) continue;
    event.tick = before_start;
    apply(event);
    log_.add(std::move(event));
  }
}

}  // namespace stepwire::live
