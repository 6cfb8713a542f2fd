#include "engine/base/data_file/table_cache.hpp"

#include <chrono>

#include "engine/base/io/file.hpp"

namespace stepwire::data_file {

namespace {

constexpr std::size_t numbers_of_process = 8'000'000;
constexpr std::chrono::seconds coarsest_clock{2};

std::size_t numbers_in(const table::Table& table) {
  std::size_t count = 0;
  for (const table::Column& column : table.columns) count += column.values.size();
  return count;
}

}  // namespace

TableCache& TableCache::of_process() {
  static TableCache cache(numbers_of_process);
  return cache;
}

/// Returns size and time of change of a file. Errors are ignored here, since reading the file reports them.
TableCache::Stamp TableCache::stamp_of(const std::string& path) {
  std::error_code none;
  Stamp stamp;
  stamp.size = std::filesystem::file_size(path, none);
  stamp.changed = std::filesystem::last_write_time(path, none);
  return stamp;
}

std::shared_ptr<const table::RecordTable> TableCache::read(const std::string& path, Decimal decimal) {
  const Stamp stamp = stamp_of(path);
  const std::string name = path + '\0' + static_cast<char>('0' + static_cast<int>(decimal));
  auto known = recent_.find(name, [&](const Known& one) { return one.stamp == stamp; });
  if (!known) {
    known = std::make_shared<const Known>(Known{stamp, read_data_file(path, decimal)});
    const bool may_change_unseen =
        stamp.changed + coarsest_clock > std::filesystem::file_time_type::clock::now();
    if (!may_change_unseen && stamp_of(path) == stamp) recent_.keep(name, known, numbers_in(known->table));
  }
  return {known, &known->table};
}

}  // namespace stepwire::data_file
