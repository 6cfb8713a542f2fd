#pragma once

#include <string>
#include <vector>

namespace stepwire::data_file {

/// A data file and what was done to it, as "decimal comma" or "2 rows without x left out".
struct FileReading {
  std::string file;
  std::vector<std::string> done;
};

/// Collects how files are read, from its making on; the last one made gets all. Safe from several threads.
class ReadingLog {
 public:
  ReadingLog();
  ~ReadingLog();
  ReadingLog(const ReadingLog&) = delete;
  ReadingLog& operator=(const ReadingLog&) = delete;

  /// Adds notes that the log does not have yet; without a log there is no effect.
  static void add(const std::string& file, const std::vector<std::string>& done);
  /// Files of the log that was made last, in the order in which they were read first.
  static std::vector<FileReading> files();

 private:
  ReadingLog* before_;
  std::vector<FileReading> files_;
};

}  // namespace stepwire::data_file
