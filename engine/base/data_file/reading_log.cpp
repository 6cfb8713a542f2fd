#include "engine/base/data_file/reading_log.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

namespace stepwire::data_file {

namespace {

struct Current {
  std::mutex mutex;
  ReadingLog* log = nullptr;
};

Current& current() {
  static Current one;
  return one;
}

}  // namespace

ReadingLog::ReadingLog() {
  const std::lock_guard lock(current().mutex);
  before_ = std::exchange(current().log, this);
}

ReadingLog::~ReadingLog() {
  const std::lock_guard lock(current().mutex);
  current().log = before_;
}

void ReadingLog::add(const std::string& file, const std::vector<std::string>& done) {
  const std::lock_guard lock(current().mutex);
  if (!current().log) return;
  std::vector<FileReading>& files = current().log->files_;
  auto known = std::ranges::find(files, file, &FileReading::file);
  if (known == files.end()) known = files.insert(files.end(), {file, {}});
  for (const std::string& one : done)
    if (std::ranges::find(known->done, one) == known->done.end()) known->done.push_back(one);
}

std::vector<FileReading> ReadingLog::files() {
  const std::lock_guard lock(current().mutex);
  return current().log ? current().log->files_ : std::vector<FileReading>{};
}

}  // namespace stepwire::data_file
