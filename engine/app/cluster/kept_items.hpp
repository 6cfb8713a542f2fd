#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/messages/items.hpp"
#include "engine/simulate/journal/byte_journal.hpp"

namespace stepwire::cluster {

/// Queue of items for other processes, and sink of their results. Not thread-safe.
class ItemSource {
 public:
  virtual ~ItemSource() = default;
  /// Returns the next item that is not given out yet; std::nullopt after the last one.
  virtual std::optional<messages::Item> next() = 0;
  /// Returns an upper limit of the number of items that next() will still return.
  virtual std::size_t left() const = 0;
  /// Stores the result of an item. Throws EnvironmentError.
  virtual void take(std::size_t number, std::string_view bytes) = 0;
  /// Returns the finished fraction, 0 to 1, for a progress display.
  virtual double done() const = 0;
};

/// Items with a journal on disk: each result is stored on arrival. A repeated call continues after an
/// interruption or a loss of processes.
class KeptItems : public ItemSource {
 public:
  /// Opens the journal and loads the results of an earlier call. `head`, one line, identifies the job;
  /// results under another head are dropped. `most` is the largest number of items. Throws EnvironmentError.
  KeptItems(const std::string& path, const std::string& head, std::size_t most);

  /// Returns the journal record of a result. The worker makes it, so that process 0 only appends it.
  static std::string record_of(std::size_t number, std::string_view bytes);

  /// Queues the items whose results are missing.
  void want(const std::vector<messages::Item>& items);
  std::optional<messages::Item> next() override;
  std::size_t left() const override { return wanted_.size(); }
  void take(std::size_t number, std::string_view bytes) override;
  double done() const override;

  /// Returns the number of stored results.
  std::size_t kept() const { return journal_.count(); }
  bool has(const messages::Item& item) const { return journal_.has(item.number); }
  /// Returns the results of the items, which must all be stored. Throws EnvironmentError if the file is
  /// damaged.
  std::vector<std::string> results(const std::vector<messages::Item>& items);
  const std::string& path() const { return journal_.path(); }

 private:
  journal::ByteJournal journal_;
  std::vector<messages::Item> wanted_;  ///< in reverse order
  std::size_t asked_ = 0;               ///< size of the last queued list
};

}  // namespace stepwire::cluster
