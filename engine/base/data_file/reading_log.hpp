#pragma once

#include <string>
#include <vector>

namespace stepwire::data_file {

/// A data file and the conversions made on reading it, such as "decimal comma" or "2 rows without x left
/// out".
struct FileReading {
  std::string file;
  std::vector<std::string> done;
};

/// Collects notes on the files read while it exists; the newest log receives them all. Thread-safe.
class ReadingLog {
 public:
  ReadingLog();
  ~ReadingLog();
  ReadingLog(const ReadingLog&) = delete;
  ReadingLog& operator=(const ReadingLog&) = delete;

  /// Adds the notes that the log does not have yet; has no effect without a log.
  static void add(const std::string& file, const std::vector<std::string>& done);
  /// Returns the files of the newest log, in the order of their first reading.
  static std::vector<FileReading> files();

 private:
  ReadingLog* before_;
  std::vector<FileReading> files_;
};

}  // namespace stepwire::data_file
