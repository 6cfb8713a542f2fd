#include "engine/simulate/realtime/row_writer.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>

#include "engine/base/io/atomic_file_writer.hpp"
#include "engine/base/table/table_file.hpp"

namespace stepwire::realtime {

namespace {

constexpr std::size_t max_at_once = 1 << 14;  // numbers per read from the ring
constexpr std::size_t full_piece = 1 << 16;   // bytes
// Few large writes: each one may hold kernel resources that the loop thread needs to wake up.
constexpr std::chrono::milliseconds nap{250};

/// Appends all digits; the shortest form of 100000 would be 1e+05.
void append_whole(std::string& text, double value) {
  text += std::to_string(static_cast<std::int64_t>(value));
}

}  // namespace

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
