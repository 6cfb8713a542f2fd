#pragma once

#include <algorithm>
#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace stepwire::data_file {

/// Cache of values by name that evicts the least recently used ones. All values together hold at most
/// `max_numbers` numbers. Thread-safe.
template <class Value>
class Recent {
 public:
  explicit Recent(std::size_t max_numbers) : max_numbers_(max_numbers) {}

  /// Returns the value of a name; nullptr if there is none. Drops a value that `is_valid` refuses.
  template <class Valid>
  std::shared_ptr<const Value> find(const std::string& name, const Valid& is_valid) {
    const std::lock_guard lock(mutex_);
    const auto entry = place(name);
    if (entry == entries_.end()) return nullptr;
    if (!is_valid(*entry->value)) {
      drop(entry);
      return nullptr;
    }
    entries_.splice(entries_.begin(), entries_, entry);
    return entry->value;
  }

  /// Stores a value that holds `numbers` numbers, and replaces an earlier one of the same name.
  void keep(const std::string& name, std::shared_ptr<const Value> value, std::size_t numbers) {
    if (numbers > max_numbers_) return;
    const std::lock_guard lock(mutex_);
    if (const auto known = place(name); known != entries_.end()) drop(known);
    while (numbers_ + numbers > max_numbers_) drop(std::prev(entries_.end()));
    numbers_ += numbers;
    entries_.push_front({name, std::move(value), numbers});
  }

  std::size_t numbers() const { return numbers_; }  ///< total over all stored values

 private:
  struct Entry {
    std::string name;
    std::shared_ptr<const Value> value;
    std::size_t numbers;
  };
  using Place = typename std::list<Entry>::iterator;

  Place place(const std::string& name) {
    return std::find_if(entries_.begin(), entries_.end(),
                        [&](const Entry& entry) { return entry.name == name; });
  }
  void drop(Place entry) {
    numbers_ -= entry->numbers;
    entries_.erase(entry);
  }

  std::size_t max_numbers_, numbers_ = 0;
  std::mutex mutex_;
  std::list<Entry> entries_;  ///< most recently used first
};

}  // namespace stepwire::data_file
