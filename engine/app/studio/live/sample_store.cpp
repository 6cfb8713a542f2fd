#include "engine/app/studio/live/sample_store.hpp"

#include <cmath>
#include <filesystem>

namespace stepwire::live {

namespace {

constexpr double missing_sample = std::numeric_limits<double>::quiet_NaN();
constexpr std::int64_t samples_per_pixel = 2;  // up to which all samples are shown

std::string folder_of(const StoreOptions& options) {
  return options.folder.empty() ? std::filesystem::temp_directory_path().string() : options.folder;
}

/// Returns the ticks of a row.
std::int64_t width_of(const SampleRange& range) {
  const std::int64_t count = range.to - range.from;
  const auto pixels = static_cast<std::int64_t>(std::max<std::size_t>(range.pixels, 1));
  if (count <= samples_per_pixel * pixels) return 1;
  const std::int64_t width = count / pixels;
  constexpr std::int64_t block = SampleColumn::block;  // the lowest level of extremes
  return width < block ? width : width / block * block;
}

void append_extremes(const SampleColumn& column, const SampleRange& range, std::int64_t width,
                     const std::vector<std::int64_t>& ticks, std::vector<std::vector<double>>& columns) {
  std::vector<double>& least = columns.emplace_back();
  least.reserve(ticks.size());
  std::vector<double> most;
  most.reserve(ticks.size());
  for (const std::int64_t tick : ticks) {
    const std::int64_t next = (tick / width + 1) * width;
    const Extremes found = column.extremes(tick, std::min(next, range.to));
    least.push_back(found.none() ? missing_sample : found.least);
    most.push_back(found.none() ? missing_sample : found.most);
  }
  columns.push_back(std::move(most));
}

/// Sums of samples relative to the first one, since a mean may be far larger than the variation.
class Sums {
 public:
  void add(double tick, double value) {
    if (std::isnan(value)) return;
    if (count_++ == 0) start_ = first_ = value, start_tick_ = tick;
    last_ = value;
    const double y = value - start_, x = tick - start_tick_;
    extremes_.take({value, value});
    y_ += y, yy_ += y * y, x_ += x, xx_ += x * x, xy_ += x * y;
  }

  SampleStatistics statistics() const {
    if (count_ == 0)
      return {missing_sample, missing_sample, missing_sample, missing_sample,
              missing_sample, missing_sample, missing_sample};
    const auto n = static_cast<double>(count_);
    const double mean = y_ / n, spread = xx_ - x_ * x_ / n;
    const double square = yy_ / n + 2.0 * start_ * mean + start_ * start_;
    return {extremes_.least,
            extremes_.most,
            start_ + mean,
            std::sqrt(std::max(0.0, square)),
            spread > 0.0 ? (xy_ - x_ * mean) / spread : missing_sample,
            first_,
            last_};
  }

 private:
  std::int64_t count_ = 0;
  double start_ = 0.0, start_tick_ = 0.0, first_ = 0.0, last_ = 0.0;
  double y_ = 0.0, yy_ = 0.0, x_ = 0.0, xx_ = 0.0, xy_ = 0.0;
  Extremes extremes_;
};

}  // namespace

SampleStore::SampleStore(double step, const StoreOptions& options)
    : times_(tick_times(step)),
      options_(options),
      in_memory_(options.chunks_in_memory),
      file_(folder_of(options), static_cast<std::size_t>(SampleColumn::chunk)) {}

std::size_t SampleStore::add(std::int64_t tick) {
  const std::lock_guard lock(mutex_);
  columns_.emplace_back(file_, tick, in_memory_);
  const std::size_t room = options_.bytes / (columns_.size() * SampleColumn::chunk * sizeof(double));
  in_memory_ = std::min(options_.chunks_in_memory, room);
  return columns_.size() - 1;
}

void SampleStore::append(std::span<const double> rows) {
  const std::lock_guard lock(mutex_);
  append_locked(rows);
}

bool SampleStore::try_append(std::span<const double> rows) {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock) return false;
  append_locked(rows);
  return true;
}

void SampleStore::append_locked(std::span<const double> rows) {
  if (columns_.empty()) return;
  const std::size_t count = rows.size() / columns_.size();
  for (std::size_t c = 0; c < columns_.size(); ++c)
    columns_[c].append(rows.data() + c, count, columns_.size());
}

void SampleStore::append_to(std::size_t column, std::span<const double> samples) {
  const std::lock_guard lock(mutex_);
  columns_.at(column).append(samples.data(), samples.size(), 1);
}

void SampleStore::put_before(std::size_t column, std::span<const double> samples) {
  const std::lock_guard lock(mutex_);
  SampleColumn& known = columns_.at(column);
  const std::int64_t first = known.first_tick();
  if (static_cast<std::int64_t>(samples.size()) != first) return;
  std::vector<double> later(static_cast<std::size_t>(known.end_tick() - first));
  known.read(first, later);
  known.cut(0);
  known.append(samples.data(), samples.size(), 1);
  known.append(later.data(), later.size(), 1);
  ++revision_;
}

std::uint32_t SampleStore::revision() const {
  const std::lock_guard lock(mutex_);
  return revision_;
}

void SampleStore::cut(std::int64_t tick) {
  const std::lock_guard lock(mutex_);
  for (SampleColumn& column : columns_) column.cut(tick);
}

std::size_t SampleStore::columns() const {
  const std::lock_guard lock(mutex_);
  return columns_.size();
}

std::int64_t SampleStore::first_tick(std::size_t column) const {
  const std::lock_guard lock(mutex_);
  return columns_.at(column).first_tick();
}

std::int64_t SampleStore::end_tick() const {
  const std::lock_guard lock(mutex_);
  return columns_.empty() ? 0 : columns_.front().end_tick();
}

SampleRows SampleStore::look(const SampleRange& range) const {
  const std::lock_guard lock(mutex_);
  SampleRange seen = range;
  seen.from = std::max<std::int64_t>(seen.from, 0);
  for (const SampleColumn& column : columns_) seen.to = std::min(seen.to, column.end_tick());
  const std::int64_t width = width_of(range);
  SampleRows rows;
  rows.extremes = width > 1;
  rows.end = seen.to;
  for (std::int64_t tick = seen.from; tick < seen.to; tick = (tick / width + 1) * width)
    rows.ticks.push_back(tick);
  for (const std::size_t index : range.columns)
    if (rows.extremes)
      append_extremes(columns_.at(index), seen, width, rows.ticks, rows.columns);
    else
      columns_.at(index).read(seen.from, rows.columns.emplace_back(rows.ticks.size()));
  return rows;
}

SampleStatistics SampleStore::statistics(std::size_t column, std::int64_t from, std::int64_t to) const {
  const std::lock_guard lock(mutex_);
  Sums sums;
  columns_.at(column).each_part(from, to, [&](std::int64_t first, std::span<const double> values) {
    for (std::size_t i = 0; i < values.size(); ++i)
      sums.add(static_cast<double>(first + static_cast<std::int64_t>(i)), values[i]);
  });
  return sums.statistics();
}

void SampleStore::read(std::size_t column, std::int64_t from, std::span<double> into) const {
  const std::lock_guard lock(mutex_);
  columns_.at(column).read(from, into);
}

}  // namespace stepwire::live
