#include "engine/app/studio/live/sample_column.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "engine/base/io/environment_error.hpp"

namespace stepwire::live {

namespace {

[[noreturn]] void refuse(const std::string& folder, const char* what) {
  throw io::EnvironmentError(
      fmt::format("{}: the samples of the run cannot be {}: {}", folder, what, std::strerror(errno)));
}

constexpr std::uint64_t left_free = std::uint64_t{1} << 30;        // bytes of free disk space
constexpr std::uint64_t between_checks = std::uint64_t{64} << 20;  // bytes written between checks of the disk

int open_without_name(const std::string& folder) {
  const int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file >= 0) return file;
  std::string name = folder + "/stepwire-samples-XXXXXX";  // for file systems without O_TMPFILE
  const int named = ::mkostemp(name.data(), O_CLOEXEC);
  if (named >= 0) ::unlink(name.c_str());
  return named;
}

/// Returns the extremes of contiguous numbers. Eight independent lanes hide the latency of the comparisons.
Extremes extremes_of(std::span<const double> values) {
  constexpr std::size_t lanes = 8;
  std::array<double, lanes> least, most;
  least.fill(Extremes{}.least);
  most.fill(Extremes{}.most);
  const std::size_t whole = values.size() / lanes * lanes;
  for (std::size_t i = 0; i < whole; i += lanes)
    for (std::size_t k = 0; k < lanes; ++k) {
      const double value = values[i + k];
      least[k] = value < least[k] ? value : least[k];
      most[k] = value > most[k] ? value : most[k];
    }
  Extremes all;
  for (std::size_t k = 0; k < lanes; ++k) all.take({least[k], most[k]});
  for (std::size_t i = whole; i < values.size(); ++i) {
    if (values[i] < all.least) all.least = values[i];
    if (values[i] > all.most) all.most = values[i];
  }
  return all;
}

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint64_t none = UINT64_MAX;

}  // namespace

SpillFile::SpillFile(const std::string& folder, std::size_t chunk)
    : folder_(folder), chunk_bytes_(chunk * sizeof(double)), file_(open_without_name(folder)) {
  if (!file_.open()) refuse(folder_, "kept");
}

std::uint64_t SpillFile::write(std::span<const double> chunk) {
  const bool again = !free_.empty();
  if (!again && end_ % between_checks == 0) leave_room();
  const std::uint64_t place = again ? free_.back() : end_;
  const char* bytes = reinterpret_cast<const char*>(chunk.data());
  for (std::size_t done = 0; done < chunk.size_bytes();) {
    const auto written =
        ::pwrite(file_.number(), bytes + done, chunk.size_bytes() - done, static_cast<off_t>(place + done));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) refuse(folder_, "written");
    done += static_cast<std::size_t>(written);
  }
  if (again) free_.pop_back();
  if (!again) end_ += chunk_bytes_;
  return place;
}

/// Throws if the disk is nearly full, as a run may continue without end.
void SpillFile::leave_room() const {
  std::error_code unknown;
  const std::filesystem::space_info space = std::filesystem::space(folder_, unknown);
  if (unknown || space.available > left_free) return;
  throw io::EnvironmentError(
      fmt::format("{}: the samples of the run leave less than 1 GiB of the disk free", folder_));
}

void SpillFile::read(std::uint64_t place, std::size_t first, std::span<double> into) const {
  char* bytes = reinterpret_cast<char*>(into.data());
  const std::uint64_t begin = place + first * sizeof(double);
  for (std::size_t done = 0; done < into.size_bytes();) {
    const auto count =
        ::pread(file_.number(), bytes + done, into.size_bytes() - done, static_cast<off_t>(begin + done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) refuse(folder_, "read");
    done += static_cast<std::size_t>(count);
  }
}

SampleColumn::SampleColumn(SpillFile& file, std::int64_t first_tick, const std::size_t& in_memory)
    : file_(file), in_memory_(in_memory) {
  start(first_tick);
}

/// Starts empty at a tick. The chunks of all columns start at the same ticks.
void SampleColumn::start(std::int64_t tick) {
  first_tick_ = tick;
  base_ = tick / chunk * chunk;
  filled_ = static_cast<std::size_t>(tick - base_);
  std::fill_n(tail_->begin(), filled_, nothing);
}

void SampleColumn::append(const double* values, std::size_t count, std::size_t stride) {
  for (std::size_t done = 0; done < count;) {
    if (filled_ == tail_->size()) seal();
    const std::size_t fitting = std::min(count - done, tail_->size() - filled_);
    double* to = tail_->data() + filled_;
    for (std::size_t i = 0; i < fitting; ++i) to[i] = values[(done + i) * stride];
    filled_ += fitting;
    done += fitting;
  }
}

void SampleColumn::seal() {
  chunks_.push_back(file_.write(*tail_));
  filled_ = 0;
  if (levels_.empty()) levels_.emplace_back();
  for (std::int64_t first = 0; first < chunk; first += block)
    levels_.front().push_back(extremes_of({tail_->data() + first, static_cast<std::size_t>(block)}));
  for (std::size_t level = 0; level < levels_.size(); ++level) raise(level);
  std::unique_ptr<Chunk> unused;
  recent_.push_back(std::move(tail_));
  while (recent_.size() > in_memory_) {
    unused = std::move(recent_.front());
    recent_.pop_front();
  }
  tail_ = unused ? std::move(unused) : std::make_unique<Chunk>();
}

/// Appends the completed blocks of the next level.
void SampleColumn::raise(std::size_t level) {
  if (levels_[level].size() < factor) return;
  if (level + 1 == levels_.size()) levels_.emplace_back();
  const std::vector<Extremes>& below = levels_[level];
  std::vector<Extremes>& above = levels_[level + 1];
  while ((above.size() + 1) * factor <= below.size()) {
    Extremes all;
    for (std::size_t i = 0; i < factor; ++i) all.take(below[above.size() * factor + i]);
    above.push_back(all);
  }
}

void SampleColumn::cut(std::int64_t tick) {
  if (tick >= end_tick()) return;
  const auto whole = static_cast<std::size_t>(std::max<std::int64_t>(0, tick - base_) / chunk);
  if (whole < chunks_.size()) {
    const auto left = static_cast<std::size_t>(std::max<std::int64_t>(0, tick - base_) % chunk);
    const std::span<const double> kept = part(base_ + static_cast<std::int64_t>(whole) * chunk, left);
    std::copy(kept.begin(), kept.end(), tail_->begin());
    recent_.resize(recent_.size() - std::min(recent_.size(), chunks_.size() - whole));
    for (std::size_t i = whole; i < chunks_.size(); ++i) file_.give_back(chunks_[i]);
    chunks_.resize(whole);
    read_index_ = none;
  }
  std::size_t blocks = whole * static_cast<std::size_t>(chunk / block);
  for (std::vector<Extremes>& level : levels_) {
    level.resize(std::min(level.size(), blocks));
    blocks /= factor;
  }
  if (tick < first_tick_) return start(tick);
  filled_ = static_cast<std::size_t>(tick - sealed_end());
}

std::span<const double> SampleColumn::part(std::int64_t begin, std::size_t count) const {
  const auto index = static_cast<std::size_t>((begin - base_) / chunk);
  const auto first = static_cast<std::size_t>((begin - base_) % chunk);
  if (index == chunks_.size()) return {tail_->data() + first, count};
  const std::size_t oldest = chunks_.size() - recent_.size();
  if (index >= oldest) return {recent_[index - oldest]->data() + first, count};
  if (!read_) read_ = std::make_unique<Chunk>();
  if (read_index_ != index) {
    read_index_ = none;
    file_.read(chunks_[index], 0, *read_);
    read_index_ = index;
  }
  return {read_->data() + first, count};
}

Extremes SampleColumn::of_samples(std::int64_t begin, std::int64_t end) const {
  Extremes all;
  each_part(begin, end, [&](std::int64_t, std::span<const double> values) { all.take(extremes_of(values)); });
  return all;
}

/// Combines blocks of the lowest levels at both ends, and of the highest levels between. Cost: logarithmic in
/// the number of blocks.
Extremes SampleColumn::of_blocks(std::size_t begin, std::size_t end) const {
  Extremes all;
  const auto take = [&](std::size_t level, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) all.take(levels_[level][i]);
  };
  for (std::size_t level = 0; begin < end; ++level) {
    const std::size_t first = (begin + factor - 1) / factor, last = end / factor;
    if (level + 1 == levels_.size() || first >= last) {
      take(level, begin, end);
      break;
    }
    take(level, begin, first * factor);
    take(level, last * factor, end);
    begin = first;
    end = last;
  }
  return all;
}

Extremes SampleColumn::extremes(std::int64_t begin, std::int64_t end) const {
  begin = std::max(begin, first_tick_);
  const std::int64_t first = (begin - base_ + block - 1) / block;
  const std::int64_t last = (std::min(end, sealed_end()) - base_) / block;
  if (first >= last) return of_samples(begin, end);
  Extremes all = of_blocks(static_cast<std::size_t>(first), static_cast<std::size_t>(last));
  all.take(of_samples(begin, base_ + first * block));
  all.take(of_samples(base_ + last * block, end));
  return all;
}

void SampleColumn::read(std::int64_t begin, std::span<double> into) const {
  std::fill(into.begin(), into.end(), nothing);
  each_part(begin, begin + static_cast<std::int64_t>(into.size()),
            [&](std::int64_t first, std::span<const double> values) {
              std::copy(values.begin(), values.end(), into.begin() + (first - begin));
            });
}

}  // namespace stepwire::live
