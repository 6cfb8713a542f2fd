#include "engine/base/data_file/table_cache.hpp"

#include <algorithm>
#include <chrono>

#include "engine/base/data_file/data_file.hpp"
#include "engine/base/io/file.hpp"

namespace stepwire {

namespace {

constexpr std::size_t numbers_of_process = 8'000'000;
constexpr std::chrono::seconds coarsest_clock{2};

std::size_t numbers_in(const Table& table) {
  std::size_t count = 0;
  for (const Column& column : table.columns) count += column.values.size();
  return count;
}

}  // namespace

TableCache& TableCache::of_process() {
  static TableCache cache(numbers_of_process);
  return cache;
}

/// Of a file that is not there or cannot be looked at, nothing: reading it tells why.
TableCache::Stamp TableCache::stamp_of(const std::string& path) {
  std::error_code none;
  Stamp stamp;
  stamp.size = std::filesystem::file_size(path, none);
  stamp.changed = std::filesystem::last_write_time(path, none);
  return stamp;
}

std::shared_ptr<const RecordTable> TableCache::read(const std::string& path) {
  const Stamp stamp = stamp_of(path);
  if (auto known = find(path, stamp)) return known;
  const auto table = std::make_shared<const RecordTable>(read_data_file(path));
  const bool may_change_unseen =
      stamp.changed + coarsest_clock > std::filesystem::file_time_type::clock::now();
  if (!may_change_unseen && stamp_of(path) == stamp) keep({path, stamp, table});
  return table;
}

std::shared_ptr<const RecordTable> TableCache::find(const std::string& path, const Stamp& stamp) {
  const std::lock_guard lock(mutex_);
  const auto entry =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.path == path; });
  if (entry == entries_.end()) return nullptr;
  if (entry->stamp != stamp) {
    drop(entry);
    return nullptr;
  }
  entries_.splice(entries_.begin(), entries_, entry);
  return entry->table;
}

void TableCache::keep(Entry entry) {
  const std::size_t count = numbers_in(*entry.table);
  if (count > max_numbers_) return;
  const std::lock_guard lock(mutex_);
  const auto same =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.path == entry.path; });
  if (same != entries_.end()) drop(same);  // another thread was faster
  while (numbers_ + count > max_numbers_) drop(std::prev(entries_.end()));
  numbers_ += count;
  entries_.push_front(std::move(entry));
}

void TableCache::drop(std::list<Entry>::iterator entry) {
  numbers_ -= numbers_in(*entry->table);
  entries_.erase(entry);
}

}  // namespace stepwire
