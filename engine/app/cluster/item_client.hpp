#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/messages/items.hpp"
#include "engine/base/messages/messages.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::cluster {

/// Client side of the item server: receives jobs and items from process 0. All calls throw EnvironmentError
/// if the connection to process 0 is lost.
class ItemClient {
 public:
  explicit ItemClient(messages::Connection& server) : server_(server) {}

  /// Waits for the next job and returns it; std::nullopt after the last one.
  std::optional<std::string> next_job();
  /// Returns the next item of the job; std::nullopt after the last one. Thread-safe.
  std::optional<messages::Item> next();
  /// Sends the result of an item. Thread-safe.
  void put(std::size_t number, std::string_view bytes);
  /// Reports that an item is refused, with its faults.
  void refuse(const yaml::Error& error);
  /// Reports that this process gives up.
  void fail(const std::string& why);

 private:
  using Clock = std::chrono::steady_clock;

  std::string wait();
  void ask();
  void send_results();

  messages::Connection& server_;
  std::mutex mutex_;
  std::uint64_t job_ = 0;
  std::vector<messages::Item> given_;  ///< in reverse order
  std::uint64_t group_ = 0;            ///< size of the last group
  Clock::time_point begun_ = Clock::now(), sent_ = begun_;
  std::string results_;
};

}  // namespace stepwire::cluster
