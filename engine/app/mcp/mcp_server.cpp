#include "engine/app/mcp/mcp_server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "engine/app/language/json_rpc.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::mcp {

using json::Json;
using language::ProtocolError;
namespace rpc = language::rpc;

namespace {

constexpr std::array versions{"2025-06-18", "2025-03-26", "2024-11-05"};
constexpr std::size_t most_cancelled = 256;
constexpr std::size_t longest_line = std::size_t{64} << 20;

constexpr const char* instructions =
    "Stepwire runs block diagrams that are written as YAML. Write a file or give its text, call check until "
    "there is no fault (each has its place and cure), then run or claims. 'blocks' and 'format' explain "
    "blocks and sections. Put what must be true into the section 'claims'.";

}  // namespace

McpServer::McpServer(std::vector<Tool> tools, Host host, std::string version, Send send)
    : tools_(std::move(tools)),
      host_(std::move(host)),
      version_(std::move(version)),
      send_(std::move(send)) {}

const std::map<std::string, McpServer::Answer>& McpServer::requests() {
  static const std::map<std::string, Answer> all{{"initialize", &McpServer::initialize},
                                                 {"ping", &McpServer::ping},
                                                 {"tools/list", &McpServer::list_tools},
                                                 {"tools/call", &McpServer::call_tool}};
  return all;
}

void McpServer::send(const Json& message) {
  const std::scoped_lock lock(sending_);
  send_(message.text(-1));
}

bool McpServer::answer_ping(const std::string& message) {
  if (message.find("ping") == std::string::npos) return false;
  try {
    const Json read = Json::parse(message);
    const Json *method = read.find("method"), *id = read.find("id");
    if (!method || !method->as_text() || *method->as_text() != "ping") return false;
    if (!id || !(id->as_text() || id->as_number())) return false;
    send(language::answer_message(*id, Json::object()));
    return true;
  } catch (const json::JsonError&) {
    return false;
  }
}

void McpServer::post(std::string message) {
  const auto is_calling = [&] {
    const std::scoped_lock lock(mutex_);
    return calls_;
  };
  if (is_calling() && answer_ping(message)) return;
  const std::string id = language::cancelled_id(message, "notifications/cancelled", "requestId");
  const std::scoped_lock lock(mutex_);
  if (id.empty()) {
    messages_.push_back(std::move(message));
  } else if (id == present_) {
    stop_.request_stop();
  } else {
    cancelled_.push_back(id);
    if (cancelled_.size() > most_cancelled) cancelled_.pop_front();
  }
  arrived_.notify_one();
}

void McpServer::close() {
  const std::scoped_lock lock(mutex_);
  closed_ = true;
  arrived_.notify_one();
}

std::optional<std::string> McpServer::next_message() {
  std::unique_lock lock(mutex_);
  arrived_.wait(lock, [&] { return closed_ || !messages_.empty(); });
  if (messages_.empty()) return std::nullopt;
  std::string message = std::move(messages_.front());
  messages_.pop_front();
  return message;
}

void McpServer::run() {
  while (const auto message = next_message()) handle(*message);
}

void McpServer::handle(const std::string& text) {
  std::optional<Json> answer;
  try {
    const Json message = Json::parse(text);
    if (!message.is_list() || message.items().empty()) {
      answer = answer_of(message);
    } else {  // a batch
      for (const Json& one : message.items())
        if (auto part = answer_of(one)) {
          if (!answer) answer = Json::list();
          answer->push(std::move(*part));
        }
    }
  } catch (const json::JsonError& error) {
    answer = language::error_message(Json(), rpc::parse_error,
                                     std::string("this message is no JSON: ") + error.what());
  }
  if (answer) send(*answer);
}

std::optional<Json> McpServer::answer_of(const Json& message) {
  const Json* const id = message.find("id");
  const Json* const method = message.find("method");
  const bool valid_id = !id || id->as_text() || id->as_number();
  if (!message.is_object() || (method && !method->as_text()) || !valid_id || (!method && !id))
    return language::error_message(Json(), rpc::invalid_request,
                                   "a request is an object with 'id', a text or number, and 'method'");
  if (!method || !id) return std::nullopt;  // answers and notifications
  const Json* const params = message.find("params");
  return answer_request(*id, *method->as_text(), params ? *params : Json::object());
}

bool McpServer::begin(const std::string& id, const std::string& method) {
  const std::scoped_lock lock(mutex_);
  const auto found = std::ranges::find(cancelled_, id);
  const bool cancelled = found != cancelled_.end();
  if (cancelled) cancelled_.erase(found);
  present_ = id;
  calls_ = method == "tools/call";
  stop_ = std::stop_source();
  return !cancelled;
}

std::optional<Json> McpServer::answer_request(const Json& id, const std::string& method, const Json& params) {
  if (!begin(id.text(-1), method)) return std::nullopt;
  Json message;
  try {
    const auto known = requests().find(method);
    if (known == requests().end())
      throw ProtocolError(rpc::no_method, fmt::format("there is no method '{}'", method));
    if (!initialized_ && method != "initialize" && method != "ping")
      throw ProtocolError(rpc::invalid_request, "'initialize' comes first");
    if (!params.is_object()) throw ProtocolError(rpc::invalid_params, "'params' is an object");
    message = language::answer_message(id, (this->*known->second)(params));
  } catch (const ProtocolError& error) {
    message = language::error_message(id, error.code, error.what());
  } catch (const std::exception& error) {
    message = language::error_message(id, rpc::internal_error, error.what());
  }
  const std::scoped_lock lock(mutex_);
  present_.clear();
  calls_ = false;
  if (stop_.stop_requested()) return std::nullopt;  // a cancelled request has no answer
  return message;
}

Json McpServer::initialize(const Json& params) {
  const std::string& wanted = language::text_member(params, "protocolVersion");
  const auto known = std::ranges::find(versions, wanted);
  initialized_ = true;
  return Json::object()
      .set("protocolVersion", known == versions.end() ? versions.front() : *known)
      .set("capabilities", Json::object().set("tools", Json::object().set("listChanged", false)))
      .set("serverInfo", Json::object().set("name", "stepwire").set("version", version_))
      .set("instructions", instructions);
}

Json McpServer::ping(const Json&) {
  return Json::object();
}

Json McpServer::list_tools(const Json& params) {
  if (const Json* cursor = params.find("cursor"); cursor && !cursor->is_null())
    throw ProtocolError(rpc::invalid_params, "there is no such cursor; all tools are on the first page");
  Json all = Json::list();
  for (const Tool& tool : tools_) all.push(description_of(tool));
  return Json::object().set("tools", std::move(all));
}

Json McpServer::call_tool(const Json& params) {
  const std::string& name = language::text_member(params, "name");
  const auto tool = std::ranges::find(tools_, name, &Tool::name);
  if (tool == tools_.end()) {
    std::vector<std::string> names;
    for (const Tool& one : tools_) names.push_back(one.name);
    throw ProtocolError(
        rpc::invalid_params,
        fmt::format(
            "there is no tool '{}'{}", name,
            yaml::did_you_mean(name, names, fmt::format("There are: {}", fmt::join(names, ", "))).text()));
  }
  const Json* const arguments = params.find("arguments");
  return mcp::call_tool(*tool, arguments && !arguments->is_null() ? *arguments : Json::object(), host_,
                        stop_.get_token());
}

std::optional<std::string> LineReader::next() {
  while (true) {
    const std::size_t end = buffer_.find('\n', searched_);
    if (end == std::string::npos) {
      searched_ = buffer_.size();
      std::array<char, 1 << 14> chunk;
      const std::size_t count = searched_ > longest_line ? 0 : read_(chunk.data(), chunk.size());
      if (count == 0 && (buffer_.empty() || searched_ > longest_line)) return std::nullopt;
      buffer_.append(count == 0 ? "\n" : std::string_view(chunk.data(), count));
      continue;
    }
    std::string line = buffer_.substr(0, end);
    buffer_.erase(0, end + 1);
    searched_ = 0;
    if (line.find_first_not_of(" \t\r") != std::string::npos) return line;
  }
}

}  // namespace stepwire::mcp
