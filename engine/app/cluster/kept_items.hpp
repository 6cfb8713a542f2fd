#pragma once

#include <string>
#include <vector>

#include "engine/app/cluster/item_source.hpp"
#include "engine/simulate/journal/byte_journal.hpp"

namespace stepwire::cluster {

/// Items whose results are kept in a file as soon as they are there, so that a call in which some were lost,
/// or that was interrupted or killed, goes on.
class KeptItems : public ItemSource {
 public:
  /// Takes what an earlier call has left of so many items at most, whose results follow from what `head`, one
  /// line, says. Throws EnvironmentError.
  KeptItems(const std::string& path, const std::string& head, std::size_t most);

  /// What the process that has done an item sends, so that this one need not make it.
  static std::string record_of(std::size_t number, std::string_view bytes);

  /// Has these done, as far as they are missing.
  void want(const std::vector<messages::Item>& items);
  std::optional<messages::Item> next() override;
  std::size_t left() const override { return wanted_.size(); }
  void take(std::size_t number, std::string_view bytes) override;
  double done() const override;

  /// How many are kept.
  std::size_t kept() const { return journal_.count(); }
  bool has(const messages::Item& item) const { return journal_.has(item.number); }
  /// What came out of these, which are all kept. Throws EnvironmentError where the file was damaged.
  std::vector<std::string> results(const std::vector<messages::Item>& items);
  const std::string& path() const { return journal_.path(); }

 private:
  journal::ByteJournal journal_;
  std::vector<messages::Item> wanted_;  ///< the next one last
  std::size_t asked_ = 0;               ///< items that want() was given last
};

}  // namespace stepwire::cluster
