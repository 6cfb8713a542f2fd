#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/app/mcp/tool.hpp"
#include "engine/app/mcp/tool_call.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::mcp {

/// Model Context Protocol over any transport of JSON texts: it lists tools and calls them, one at a time.
/// Source: Model Context Protocol 2024-11-05, 2025-03-26 and 2025-06-18, JSON-RPC 2.0.
class McpServer {
 public:
  /// Sends a message as one line of JSON. One thread at a time calls it: that of run(), or of post() for a
  /// ping.
  using Send = std::function<void(const std::string& message)>;

  McpServer(std::vector<Tool> tools, Host host, std::string version, Send send);

  /// Queues a message. Thread-safe. A notification that cancels a request takes effect at once, and a ping is
  /// answered at once beside a call of a tool.
  void post(std::string message);
  /// Ends run() after the queued messages. Thread-safe.
  void close();
  /// Handles messages until close().
  void run();

 private:
  using Answer = json::Json (McpServer::*)(const json::Json& params);
  static const std::map<std::string, Answer>& requests();

  std::optional<std::string> next_message();
  void handle(const std::string& text);
  /// Returns the answer of one message; std::nullopt for a notification and a cancelled request.
  std::optional<json::Json> answer_of(const json::Json& message);
  std::optional<json::Json> answer_request(const json::Json& id, const std::string& method,
                                           const json::Json& params);
  /// Makes a request the present one; false if it is already cancelled.
  bool begin(const std::string& id, const std::string& method);

  json::Json initialize(const json::Json& params);
  json::Json ping(const json::Json& params);
  /// Answers a ping; false for any other message.
  bool answer_ping(const std::string& message);
  void send(const json::Json& message);
  json::Json list_tools(const json::Json& params);
  json::Json call_tool(const json::Json& params);

  std::vector<Tool> tools_;
  Host host_;
  std::string version_;
  Send send_;
  bool initialized_ = false;

  std::mutex sending_;  ///< protects send_
  std::mutex mutex_;    ///< protects the members below
  std::condition_variable arrived_;
  std::deque<std::string> messages_;
  std::deque<std::string> cancelled_;  ///< ids of waiting requests, as JSON text
  std::string present_;                ///< id of the request that is being answered, as JSON text
  std::stop_source stop_;              ///< of that request
  bool calls_ = false;                 ///< it calls a tool
  bool closed_ = false;
};

/// Reads lines of a byte stream: messages of the protocol.
class LineReader {
 public:
  /// Reads at most `most` bytes and returns their count; 0 at the end of the stream.
  using Read = std::function<std::size_t(char* to, std::size_t most)>;

  explicit LineReader(Read read) : read_(std::move(read)) {}
  /// Returns the next line that is not empty; std::nullopt at the end of the stream, and for a line above
  /// 64 MB.
  std::optional<std::string> next();

 private:
  Read read_;
  std::string buffer_;
  std::size_t searched_ = 0;  ///< bytes of the buffer without a line end
};

}  // namespace stepwire::mcp
