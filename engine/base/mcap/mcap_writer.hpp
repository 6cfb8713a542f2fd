#pragma once

#include <memory>
#include <string>

#include "engine/base/table/run_view.hpp"

namespace stepwire::mcap {

/// Writes runs into an MCAP file, which appears whole under its name or not at all: each run is a channel of
/// JSON messages, one for each row, logged at its time in ns. What a run sets is metadata of its channel. What
/// is no finite number is null. The same runs give the same bytes. Methods throw EnvironmentError where the
/// system refuses or there are more runs than channels can be (65,535).
class McapWriter {
 public:
  /// `title` is that of the schemas.
  McapWriter(const std::string& path, const std::string& title);
  ~McapWriter();
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;

  void add(const table::RunView& run);
  /// Gives the file its name.
  void finish();

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace stepwire::mcap
