#include "engine/app/cluster/kept_items.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/owned_folder.hpp"

namespace stepwire::cluster {

KeptItems::KeptItems(const std::string& path, const std::string& head, std::size_t most)
    : journal_((io::note_written(path), path), head, most, journal::ByteJournal::Use::write) {}

void KeptItems::want(const std::vector<messages::Item>& items) {
  wanted_.clear();
  for (const messages::Item& item : items)
    if (!has(item)) wanted_.push_back(item);
  std::ranges::reverse(wanted_);
  asked_ = items.size();
}

std::optional<messages::Item> KeptItems::next() {
  if (wanted_.empty()) return std::nullopt;
  messages::Item item = std::move(wanted_.back());
  wanted_.pop_back();
  return item;
}

std::string KeptItems::record_of(std::size_t number, std::string_view bytes) {
  const std::uint64_t head = number;
  std::string record(reinterpret_cast<const char*>(&head), sizeof(head));
  return journal::ByteJournal::record_of(record.append(bytes));
}

void KeptItems::take(std::size_t number, std::string_view bytes) {
  journal_.add_record(number, bytes);
}

double KeptItems::done() const {
  return asked_ == 0 ? 1.0 : 1.0 - static_cast<double>(left()) / static_cast<double>(asked_);
}

std::vector<std::string> KeptItems::results(const std::vector<messages::Item>& items) {
  std::vector<std::string> all(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto bytes = journal_.bytes(items[i].number);
    if (!bytes) continue;
    if (bytes->size() < sizeof(std::uint64_t))
      throw io::EnvironmentError(fmt::format("{}: was changed by somebody else; remove it", path()));
    all[i] = bytes->substr(sizeof(std::uint64_t));
  }
  return all;
}

}  // namespace stepwire::cluster
