// Driver that plays a record as a device would, and records what is written to it.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fstream>
#include <sstream>
#include <utility>

#include "engine/drivers/support/table.hpp"

namespace {

using stepwire::support::Channels;
using stepwire::support::Settings;

constexpr std::size_t most_numbers = 1u << 23;  // of what is recorded, 64 MB

std::int64_t now() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

/// Table of numbers by time [ns], row by row.
struct Record {
  std::vector<std::string> names;  ///< without the time
  std::vector<std::int64_t> times;
  std::vector<double> values;

  explicit Record(const std::string& path) : path_(path) {
    std::ifstream file(path);
    std::string line;
    if (!file) refuse_to_open(path);
    if (!std::getline(file, line)) throw std::runtime_error("the record " + path + " is empty");
    names = cells_of(line);
    if (names.empty() ||
        Channels::name_and_unit(names.front()) != std::pair<std::string, std::string>("time", "s"))
      throw std::runtime_error("the first column of " + path + " is not 'time [s]'");
    names.erase(names.begin());
    for (int number = 2; std::getline(file, line); ++number)
      if (!line.empty()) add(cells_of(line), number);
    if (times.empty()) throw std::runtime_error("the record " + path + " has no row");
  }

 private:
  [[noreturn]] static void refuse_to_open(const std::string& path) {
    const int reason = errno;
    throw std::runtime_error("the record " + path +
                             (reason == ENOENT ? std::string(" does not exist")
                                               : " cannot be read: " + std::string(std::strerror(reason))));
  }
  void add(const std::vector<std::string>& cells, int line) {
    if (cells.size() != names.size() + 1) refuse(line, "has another number of columns than the first one");
    for (std::size_t i = 0; i < cells.size(); ++i) {
      char* end = nullptr;
      const double value = std::strtod(cells[i].c_str(), &end);
      if (end == cells[i].c_str() || !std::isfinite(value)) refuse(line, "has a cell that is no number");
      if (i > 0)
        values.push_back(value);
      else
        times.push_back(std::llround(value * 1e9));
    }
    if (times.size() > 1 && times.back() <= times[times.size() - 2])
      refuse(line, "is not later than the one before");
  }
  [[noreturn]] void refuse(int line, const char* what) const {
    throw std::runtime_error("line " + std::to_string(line) + " of " + path_ + " " + what);
  }

  std::string path_;
};

/// New file of lines. Where the disk is full it has the lines before, each of them whole.
class LineFile {
 public:
  explicit LineFile(const std::string& path)
      : file_(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
    if (file_ < 0) trouble_ = errno;
  }
  ~LineFile() {
    if (file_ >= 0) ::close(file_);
  }
  LineFile(const LineFile&) = delete;
  LineFile& operator=(const LineFile&) = delete;

  void add(const std::string& line) {
    constexpr std::size_t piece = 1 << 16;  // bytes
    waiting_ += line + "\n";
    if (waiting_.size() >= piece) flush();
  }
  void finish() {
    flush();
    if (file_ >= 0 && ::close(std::exchange(file_, -1)) != 0 && trouble_ == 0) trouble_ = errno;
  }
  std::size_t lines() const { return lines_; }
  int trouble() const { return trouble_; }

 private:
  /// Writes what is waiting, and cuts a last line that is not whole.
  void flush() {
    std::size_t done = 0;
    while (trouble_ == 0 && done < waiting_.size()) {
      const ssize_t count = ::write(file_, waiting_.data() + done, waiting_.size() - done);
      if (count > 0)
        done += static_cast<std::size_t>(count);
      else if (count == 0 || errno != EINTR)
        trouble_ = count == 0 ? ENOSPC : errno;
    }
    const std::size_t whole = done == 0 ? 0 : waiting_.rfind('\n', done - 1) + 1;
    lines_ += static_cast<std::size_t>(
        std::count(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(whole), '\n'));
    bytes_ += static_cast<off_t>(whole);
    if (done > whole && ::ftruncate(file_, bytes_) != 0 && trouble_ == 0) trouble_ = errno;
    waiting_.clear();
  }

  int file_;
  int trouble_ = 0;
  std::size_t lines_ = 0;
  off_t bytes_ = 0;
  std::string waiting_;
};

class FileDevice {
 public:
  explicit FileDevice(const Settings& settings)
      : latency_(settings.time("latency", 0.0)),
        by_reads_(settings.word("pace", {"clock", "reads"}) == 1),
        holds_(settings.word("end", {"stop", "hold"}) == 1),
        out_(settings.text("record", "")) {
    if (settings.has("play")) load(settings.text("play"));
    channels_.add_list(settings.text("outputs", ""), STEPWIRE_OUTPUT);
    if (channels_.table().empty()) throw std::runtime_error("neither 'play' nor 'outputs' gives a channel");
    if (!out_.empty() && channels_.count(STEPWIRE_OUTPUT) == 0)
      throw std::runtime_error("'record' needs 'outputs', the names of what is written");
  }

  const Channels& channels() const { return channels_; }

  void start(std::int64_t period, const double* safe) {
    const std::size_t width = channels_.count(STEPWIRE_OUTPUT);
    period_ = period;
    safe_.assign(safe, safe + width);
    if (!out_.empty()) {
      written_.assign(most_numbers / (width + 1) * (width + 1), 0.0);
      check_writable();
    }
    begin_ = now();
  }

  int read(double* values) {
    if (reads_ == 0) first_read_ = now();
    const std::int64_t time = (by_reads_ ? reads_ * period_ : now() - first_read_) - latency_;
    ++reads_;
    while (row_ + 1 < times_.size() && times_[row_ + 1] <= time) ++row_;
    const std::size_t width = channels_.count(STEPWIRE_INPUT);
    std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(row_ * width), width, values);
    const bool is_over = !times_.empty() && row_ + 1 == times_.size() && time >= times_.back() + period_;
    return is_over && !holds_ ? STEPWIRE_ENDED : STEPWIRE_OK;
  }

  int write(const double* values) {
    const std::size_t width = channels_.count(STEPWIRE_OUTPUT) + 1;
    if (rows_ * width + width > written_.size()) {
      lost_ += out_.empty() ? 0 : 1;
      return STEPWIRE_OK;
    }
    double* const row = written_.data() + rows_++ * width;
    row[0] = static_cast<double>(by_reads_ ? reads_ * period_ : now() - begin_) * 1e-9;
    std::copy_n(values, width - 1, row + 1);
    return STEPWIRE_OK;
  }

  int safe() { return write(safe_.data()); }

  void stop() {
    if (out_.empty()) return;
    LineFile file(out_);
    std::string line = "time [s]";
    for (const stepwire_channel& one : channels_.table())
      if (one.direction == STEPWIRE_OUTPUT)
        line += std::string(",") + one.name + (*one.unit ? " [" + std::string(one.unit) + "]" : "");
    file.add(line);
    const std::size_t width = channels_.count(STEPWIRE_OUTPUT) + 1;
    for (std::size_t row = 0; row < rows_; ++row) {
      line.clear();
      for (std::size_t i = row * width; i < (row + 1) * width; ++i)
        line += (line.empty() ? "" : ",") + text_of(written_[i]);
      file.add(line);
    }
    file.finish();
    kept_ = std::max<std::size_t>(1, file.lines()) - 1;
    trouble_ = file.trouble();
  }

  void report(char* text, std::size_t size) const {
    std::string failure;
    if (trouble_ != 0)
      failure = "failed: the record " + out_ + " has " + std::to_string(kept_) + " of " +
                std::to_string(rows_) + " rows: " + std::strerror(trouble_) + "\n";
    std::snprintf(text, size, "%s%lld reads, %zu rows written%s", failure.c_str(),
                  static_cast<long long>(reads_), trouble_ != 0 ? kept_ : rows_,
                  lost_ > 0 ? ", further ones lost for want of memory" : "");
  }

 private:
  void load(const std::string& path) {
    Record record(path);
    for (const std::string& name : record.names) channels_.add_list(name, STEPWIRE_INPUT);
    times_ = std::move(record.times);
    values_ = std::move(record.values);
  }
  static std::string text_of(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.17g", value);
    return text.data();
  }
  void check_writable() const {
    std::FILE* const file = std::fopen(out_.c_str(), "w");
    if (!file) throw std::runtime_error("the record " + out_ + " cannot be written");
    std::fclose(file);
  }

  Channels channels_;
  std::int64_t latency_, period_ = 0, begin_ = 0, first_read_ = 0, reads_ = 0, lost_ = 0;
  bool by_reads_, holds_;
  std::string out_;
  std::vector<std::int64_t> times_;
  std::vector<double> values_, written_, safe_;
  std::size_t row_ = 0, rows_ = 0;
  std::size_t kept_ = 0;  ///< rows in the file
  int trouble_ = 0;       ///< of the file, as errno
};

constexpr stepwire_known_setting settings[] = {
    {"play", "record whose columns after 'time [s]' are the inputs (CSV)", ""},
    {"pace",
     "clock: a row counts from its time after the first read on; reads: each read is one period later",
     "clock"},
    {"latency", "time by which a row is seen later", "0 s"},
    {"end", "stop: the loop ends after the last row; hold: the last row counts on", "stop"},
    {"outputs", "names of the outputs with their units: a in V, b", ""},
    {"record", "file that gets what is written (CSV)", ""},
    {nullptr, nullptr, nullptr}};

}  // namespace

extern "C" const stepwire_driver* stepwire_driver_v1(void) {
  static const stepwire_driver driver = stepwire::support::driver_table<FileDevice>(
      "file", "plays a record, and records what is written", settings);
  return &driver;
}
