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

/// The jobs and items that process 0 gives to this one. Throws EnvironmentError where process 0 has gone.
class ItemClient {
 public:
  explicit ItemClient(messages::Connection& server) : server_(server) {}

  /// What the next job is, once the last one has come to its end; nothing where there are no more.
  std::optional<std::string> next_job();
  /// An item of the job; nothing once there is none. From any thread.
  std::optional<messages::Item> next();
  /// What came out of an item. From any thread.
  void put(std::size_t number, std::string_view bytes);
  /// Says that an item is refused.
  void refuse(const yaml::Error& error);
  /// Says why this process gives up.
  void fail(const std::string& why);

 private:
  using Clock = std::chrono::steady_clock;

  std::string wait();
  void ask();
  void send_results();

  messages::Connection& server_;
  std::mutex mutex_;
  std::uint64_t job_ = 0;
  std::vector<messages::Item> given_;  ///< the next one last
  std::uint64_t group_ = 0;            ///< how many items were given at once
  Clock::time_point begun_ = Clock::now(), sent_ = begun_;
  std::string results_;
};

}  // namespace stepwire::cluster
