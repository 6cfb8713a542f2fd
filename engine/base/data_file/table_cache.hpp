#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "engine/base/data_file/data_file.hpp"
#include "engine/base/data_file/recent.hpp"
#include "engine/base/table/record_table.hpp"

namespace stepwire::data_file {

/// Cache of tables read from files, so that a record used by many runs is parsed once. Evicts the least
/// recently used tables beyond `max_numbers` numbers. Thread-safe.
class TableCache {
 public:
  explicit TableCache(std::size_t max_numbers) : recent_(max_numbers) {}

  /// Returns the table in a data file, as read_data_file() reads it and with its errors. The cached object is
  /// returned while size and time of change of the file are the same. A file that changed within the last two
  /// seconds is read again, since file system clocks are coarse.
  std::shared_ptr<const table::RecordTable> read(const std::string& path, Decimal decimal = Decimal::detect);
  /// Cache of this process, for 64 MB of numbers.
  static TableCache& of_process();

  std::size_t numbers() const { return recent_.numbers(); }  ///< total over all cached tables

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
