#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "engine/base/data_file/data_file.hpp"
#include "engine/base/data_file/recent.hpp"
#include "engine/base/table/record_table.hpp"

namespace stepwire::data_file {

/// Tables as they were read from files, so that a record which many runs play is parsed once. Safe from
/// several threads. Those that were asked for longest ago go where all together would hold more than
/// `max_numbers`.
class TableCache {
 public:
  explicit TableCache(std::size_t max_numbers) : recent_(max_numbers) {}

  /// The table in a data file, as read_data_file() reads it and with its errors. What was read
  /// before is given, the same object, as long as the file has the same size and time of change; a file that
  /// changed within the last two seconds is read anew, since clocks of file systems are coarse.
  std::shared_ptr<const table::RecordTable> read(const std::string& path, Decimal decimal = Decimal::detect);
  /// Of this process, for 64 MB of numbers.
  static TableCache& of_process();

  std::size_t numbers() const { return recent_.numbers(); }  ///< that are kept

 private:
  struct Stamp {
    std::uintmax_t size = 0;
    std::filesystem::file_time_type changed;
    bool operator==(const Stamp&) const = default;
  };
  struct Known {
    Stamp stamp;
    table::RecordTable table;
  };

  static Stamp stamp_of(const std::string& path);

  Recent<Known> recent_;  ///< by path and decimal mark
};

}  // namespace stepwire::data_file
