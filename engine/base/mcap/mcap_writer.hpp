#pragma once

#include <memory>
#include <string>

#include "engine/base/table/run_view.hpp"

namespace stepwire::mcap {

/// Writes runs into an MCAP file. The file appears under its name complete or not at all. Each run is a
/// channel of JSON messages, one a row, logged at its time in ns. Values set by a run are metadata of its
/// channel. Non-finite numbers become null. The same runs give the same bytes. Methods throw EnvironmentError
/// where the system refuses or there are more runs than channel numbers (65,535).
class McapWriter {
 public:
  /// `title` is the title of the schemas.
  McapWriter(const std::string& path, const std::string& title);
  ~McapWriter();
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;

  void add(const table::RunView& run);
  /// Closes the file and moves it to its name.
  void finish();

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace stepwire::mcap
