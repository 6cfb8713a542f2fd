#include "engine/app/cluster/item_client.hpp"

#include <algorithm>

#include "engine/app/cluster/item_messages.hpp"
#include "engine/base/messages/bytes.hpp"
#include "engine/simulate/journal/run_bytes.hpp"

namespace stepwire::cluster {

using messages::ByteReader;
using messages::ByteWriter;

namespace {

constexpr std::size_t most_waiting = std::size_t{1} << 20, most_beside = std::size_t{1} << 14;
constexpr std::chrono::seconds longest_wait{1};

}  // namespace

std::string ItemClient::wait() {
  while (true)
    if (auto message = server_.receive(std::chrono::hours{1}); message && !message->empty()) return *message;
}

std::optional<std::string> ItemClient::next_job() {
  server_.send(std::string(1, kind::wants_job));
  const std::string message = wait();
  if (message.front() != kind::job) return std::nullopt;
  ByteReader reader(std::string_view(message).substr(1));
  std::string job;
  all(reader, job_, job);
  group_ = 0;
  return job;
}

std::optional<messages::Item> ItemClient::next() {
  const std::lock_guard lock(mutex_);
  if (given_.empty()) ask();
  if (given_.empty()) return std::nullopt;
  messages::Item item = std::move(given_.back());
  given_.pop_back();
  return item;
}

void ItemClient::ask() {
  if (results_.size() > most_beside) send_results();  // keeps the request short
  const double seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
  ByteWriter writer;
  all(writer, kind::wants_items, job_, group_, seconds, results_);
  server_.send(writer.take());
  results_.clear();
  const std::string message = wait();
  ByteReader reader(std::string_view(message).substr(1));
  while (message.front() == kind::items && !reader.at_end() && reader.whole()) {
    messages::Item& item = given_.emplace_back();
    all(reader, item.number, item.bytes);
  }
  std::ranges::reverse(given_);
  group_ = given_.size();
  begun_ = sent_ = Clock::now();
}

void ItemClient::put(std::size_t number, std::string_view bytes) {
  const std::lock_guard lock(mutex_);
  const std::uint64_t head[2] = {number, bytes.size()};
  results_.append(reinterpret_cast<const char*>(head), sizeof(head)).append(bytes);
  if (results_.size() >= most_waiting || Clock::now() - sent_ >= longest_wait) send_results();
}

void ItemClient::send_results() {
  server_.send(kind::results + results_);
  results_.clear();
  sent_ = Clock::now();
}

void ItemClient::refuse(const yaml::Error& error) {
  ByteWriter writer;
  writer.put(kind::refused);
  list(writer, error.faults(), [&](const yaml::Fault& fault) { journal::fault(writer, fault); });
  server_.send(writer.take());
}

void ItemClient::fail(const std::string& why) {
  server_.send(kind::failed + why);
}

}  // namespace stepwire::cluster
