#include "engine/simulate/realtime/loop_recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>

#include "engine/base/io/atomic_file_writer.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/simulate/record/recorder.hpp"

namespace stepwire::realtime {

namespace {

constexpr std::size_t before_signals = 4;  // index of the file, time, tick, wall
constexpr std::size_t before_inputs = 3;

/// Refuses a signal with the name of a column of the loop, which would be twice in the file.
void refuse_taken(const plan::Plan& plan, const std::string& name, const diagram::Origin& origin,
                  yaml::Faults& faults) {
  for (const std::string taken : {"time", "tick", "wall"})
    if (name == taken)
      faults.add(plan.diagram.fault(
          origin, name, "is also the name of a column that a loop records; give the block another name"));
}

LoopFile signals_file(const plan::Plan& plan, std::size_t index, yaml::Faults& faults) {
  const diagram::RecordRequest& request = plan.diagram.records[index];
  if (request.instants)
    faults.add(plan.diagram.fault(request.origin, "record",
                                  "a loop by the clock records at ticks alone; leave 'instants' out"));
  LoopFile file{io::numbered("signals", index, ".csv"),
                {{"time", "s", {}}, {"tick", "", {}}, {"wall", "s", {}}}};
  for (const diagram::RecordedSignal& signal : request.signals)
    refuse_taken(plan, signal.name, signal.origin, faults);
  const auto columns = record::recorded_columns(plan, request);
  for (std::size_t i = 1; i < columns.size(); ++i)
    file.columns.push_back(
        {columns[i].name, columns[i].dimension ? unit::si_name(*columns[i].dimension) : "", {}});
  return file;
}

LoopFile inputs_file(const plan::Plan& plan, yaml::Faults& faults) {
  LoopFile file{"inputs.csv", {{"time", "s", {}}, {"tick", "", {}}}};
  for (const diagram::DiagramInput& input : plan.diagram.inputs) {
    const auto block = static_cast<std::size_t>(input.block);
    refuse_taken(plan, input.name, plan.diagram.blocks[block].origin, faults);
    const auto& dimension = plan.diagram.output_dimensions[block].front();
    const Eigen::Index size = plan.blocks[block].outputs.front().size;
    for (Eigen::Index k = 0; k < size; ++k)
      file.columns.push_back({size == 1 ? input.name : fmt::format("{}.{}", input.name, k + 1),
                              dimension ? unit::si_name(*dimension) : "",
                              {}});
  }
  return file;
}

std::size_t input_elements(const plan::Plan& plan) {
  std::size_t count = 0;
  for (const diagram::DiagramInput& input : plan.diagram.inputs)
    count +=
        static_cast<std::size_t>(plan.blocks[static_cast<std::size_t>(input.block)].outputs.front().size);
  return count;
}

constexpr std::size_t max_at_once = 1 << 14;  // numbers per read from the ring
constexpr std::size_t full_piece = 1 << 16;   // bytes
// Few large writes: each one may hold kernel resources that the loop thread needs to wake up.
constexpr std::chrono::milliseconds nap{250};

/// Appends all digits; the shortest form of 100000 would be 1e+05.
void append_whole(std::string& text, double value) {
  text += std::to_string(static_cast<std::int64_t>(value));
}

}  // namespace

std::vector<LoopFile> loop_files(const plan::Plan& plan) {
  std::vector<LoopFile> files;
  yaml::Faults faults;
  for (std::size_t i = 0; i < plan.diagram.records.size(); ++i)
    files.push_back(signals_file(plan, i, faults));
  if (!plan.diagram.inputs.empty()) files.push_back(inputs_file(plan, faults));
  faults.throw_if_any();
  return files;
}

LoopRecorder::LoopRecorder(const plan::Plan& plan, RowRing& ring) : ring_(ring), time_of_(plan.tick_times) {
  for (const diagram::RecordRequest& request : plan.diagram.records) {
    Signals& signals = signals_.emplace_back();
    signals.every = record::ticks_between_rows(plan, request);
    const auto columns = record::recorded_columns(plan, request);
    for (std::size_t i = 1; i < columns.size(); ++i) signals.offsets.push_back(columns[i].offset);
    signals.row.assign(before_signals + signals.offsets.size(), 0.0);
    signals.row[0] = static_cast<double>(signals_.size() - 1);
  }
  inputs_row_.assign(before_inputs + input_elements(plan), 0.0);
  inputs_row_[0] = static_cast<double>(signals_.size());
}

void LoopRecorder::record_signals(std::int64_t tick, double wall, const double* values) {
  for (Signals& signals : signals_) {
    if (tick != signals.next_tick) continue;
    signals.next_tick += signals.every;
    signals.row[1] = time_of_(tick);
    signals.row[2] = static_cast<double>(tick);
    signals.row[3] = wall;
    for (std::size_t i = 0; i < signals.offsets.size(); ++i)
      signals.row[before_signals + i] = values[signals.offsets[i]];
    push(signals.row);
  }
}

void LoopRecorder::record_inputs(std::int64_t tick, const double* inputs) {
  if (inputs_row_.size() == before_inputs) return;
  inputs_row_[1] = time_of_(tick);
  inputs_row_[2] = static_cast<double>(tick);
  std::copy_n(inputs, inputs_row_.size() - before_inputs, inputs_row_.begin() + before_inputs);
  push(inputs_row_);
}

void LoopRecorder::push(const std::vector<double>& row) {
  ++(ring_.push(row.data(), row.size()) ? rows_ : lost_);
}

std::size_t LoopRecorder::numbers_per_tick(const plan::Plan& plan) {
  std::size_t count = plan.diagram.inputs.empty() ? 0 : before_inputs + input_elements(plan);
  for (const diagram::RecordRequest& request : plan.diagram.records)
    count += before_signals + record::recorded_columns(plan, request).size() - 1;
  return count;
}

/// File and the rows that wait to be written to it.
class RowWriter::Sink {
 public:
  Sink(const std::string& path, const std::vector<table::Column>& columns)
      : file(path), width_(columns.size()) {
    table::append_csv_head(text_, columns);
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (columns[i].name == "tick") tick_ = i;
    file.append(text_);
    text_.clear();
  }

  std::size_t width() const { return width_; }
  void add(const double* row) {
    for (std::size_t i = 0; i < width_; ++i) {
      if (i > 0) text_ += ',';
      i == tick_ ? append_whole(text_, row[i]) : table::append_csv_number(text_, row[i]);
    }
    text_ += '\n';
    ++waiting_;
    if (text_.size() >= full_piece) flush();
  }
  void flush() {
    if (text_.empty()) return;
    (file.try_append(text_) ? written : lost) += waiting_;
    if (written > 0) file.publish();
    waiting_ = 0;
    text_.clear();
  }

  io::AtomicFileWriter file;
  std::int64_t written = 0, lost = 0;  ///< rows

 private:
  std::size_t width_, tick_ = 0;
  std::string text_;
  std::int64_t waiting_ = 0;
};

RowWriter::RowWriter(RowRing& ring, const std::string& folder, const std::vector<LoopFile>& files)
    : ring_(ring) {
  std::size_t widest = 0;
  for (const LoopFile& file : files) {
    sinks_.push_back(std::make_unique<Sink>(folder + "/" + file.name, file.columns));
    widest = std::max(widest, file.columns.size() + 1);
  }
  numbers_.resize(max_at_once + widest);
  thread_ = std::thread([this] { work(); });
}

RowWriter::~RowWriter() {
  stop();
}

void RowWriter::stop() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  ended_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void RowWriter::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    const bool last = ending_;  // read before the ring, so that all rows pushed before the end are found
    lock.unlock();
    while (take()) {
    }
    for (auto& sink : sinks_) sink->flush();
    if (last) return;
    lock.lock();
    ended_.wait_for(lock, nap, [this] { return ending_; });
  }
}

/// Reads from the ring; returns false if it was empty.
bool RowWriter::take() {
  const std::size_t got = ring_.pop(numbers_.data() + filled_, numbers_.size() - filled_);
  filled_ += got;
  std::size_t at = 0;
  while (at < filled_) {
    Sink& sink = *sinks_[static_cast<std::size_t>(numbers_[at])];
    if (at + 1 + sink.width() > filled_) break;
    sink.add(numbers_.data() + at + 1);
    at += 1 + sink.width();
  }
  std::copy(numbers_.begin() + static_cast<std::ptrdiff_t>(at),
            numbers_.begin() + static_cast<std::ptrdiff_t>(filled_), numbers_.begin());
  filled_ -= at;
  return got > 0;
}

void RowWriter::finish() {
  stop();
  for (const auto& sink : sinks_) {
    rows_ += sink->written;
    lost_ += sink->lost;
    sink->file.finish();
  }
}

std::string RowWriter::trouble() const {
  for (const auto& sink : sinks_)
    if (!sink->file.trouble().empty()) return sink->file.trouble();
  return {};
}

}  // namespace stepwire::realtime
