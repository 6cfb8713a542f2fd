#include "tests/engine/app/studio/raw_client.hpp"

#include <fmt/format.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>

namespace stepwire {

using json::Json;
using std::chrono::milliseconds;

namespace {

constexpr milliseconds patience{5000};

io::Descriptor connected(const sockaddr* address, socklen_t size) {
  io::Descriptor socket(::socket(address->sa_family, SOCK_STREAM | SOCK_CLOEXEC, 0));
  return ::connect(socket.number(), address, size) == 0 ? std::move(socket) : io::Descriptor();
}

io::Descriptor connected_v4(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return connected(reinterpret_cast<const sockaddr*>(&address), sizeof address);
}

io::Descriptor connected_v6(std::uint16_t port) {
  sockaddr_in6 address{};
  address.sin6_family = AF_INET6;
  address.sin6_port = htons(port);
  address.sin6_addr = in6addr_loopback;
  return connected(reinterpret_cast<const sockaddr*>(&address), sizeof address);
}

std::string length_of(std::size_t size) {
  std::string bytes;
  const int more = size < 126 ? 0 : size < 65536 ? 2 : 8;
  bytes += static_cast<char>(0x80 | (more == 0 ? static_cast<int>(size) : more == 2 ? 126 : 127));
  for (int i = more - 1; i >= 0; --i) bytes += static_cast<char>(size >> (8 * i));
  return bytes;
}

std::uint64_t number(const std::string& bytes) {
  std::uint64_t value = 0;
  for (const char c : bytes) value = value << 8 | static_cast<unsigned char>(c);
  return value;
}

}  // namespace

const std::string upgrade_lines =
    "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";

RawClient::RawClient(std::uint16_t port, bool v6) : socket_(v6 ? connected_v6(port) : connected_v4(port)) {}

void RawClient::send(const std::string& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t count = ::send(socket_.number(), bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (count <= 0) return;
    sent += static_cast<std::size_t>(count);
  }
}

bool RawClient::fill(milliseconds time) {
  pollfd ready{socket_.number(), POLLIN, 0};
  if (closed_ || ::poll(&ready, 1, static_cast<int>(time.count())) != 1) return false;
  std::string piece(1 << 16, '\0');
  const ssize_t got = ::recv(socket_.number(), piece.data(), piece.size(), 0);
  closed_ = got <= 0;
  if (got > 0) buffer_.append(piece, 0, static_cast<std::size_t>(got));
  return !closed_;
}

std::string RawClient::receive(std::size_t bytes) {
  while (buffer_.size() < bytes && fill(patience)) {
  }
  const std::string taken = buffer_.substr(0, bytes);
  buffer_.erase(0, taken.size());
  return taken;
}

std::string RawClient::receive_until(const std::string& mark) {
  while (buffer_.find(mark) == std::string::npos && fill(patience)) {
  }
  const std::size_t at = buffer_.find(mark);
  return receive(at == std::string::npos ? buffer_.size() : at + mark.size());
}

std::string RawClient::receive_all() {
  while (fill(patience)) {
  }
  return std::exchange(buffer_, "");
}

bool RawClient::is_closed_within(milliseconds time) {
  const auto end = std::chrono::steady_clock::now() + time;
  while (!closed_ && std::chrono::steady_clock::now() < end) {
    fill(milliseconds(10));
    buffer_.clear();
  }
  return closed_;
}

std::string Head::text() const {
  const std::string line = host.empty() ? "" : "Host: " + host + "\r\n";
  return fmt::format("{} {} HTTP/1.1\r\n{}{}\r\n", method, target, line, more);
}

std::string cookie_line(const http::Key& key) {
  return fmt::format("Cookie: {}={}\r\n", http::cookie_name(key), key.token);
}

std::string host_of(const http::Key& key) {
  return fmt::format("127.0.0.1:{}", key.port);
}

std::string answer_to(const http::Key& key, const Head& head) {
  RawClient client(key.port);
  Head closing = head;
  if (closing.more.find("Connection:") == std::string::npos) closing.more += "Connection: close\r\n";
  client.send(closing.text());
  return client.receive_all();
}

PageClient::PageClient(const http::Key& key) : raw_(key.port) {
  const std::string host = host_of(key);
  raw_.send(Head{.target = "/socket",
                 .host = host,
                 .more = "Origin: http://" + host + "\r\n" + cookie_line(key) + upgrade_lines}
                .text());
  open_ = raw_.receive_until("\r\n\r\n").starts_with("HTTP/1.1 101 ");
}

void PageClient::send(const std::string& message, int kind) {
  raw_.send(static_cast<char>(0x80 | kind) + length_of(message.size()) + std::string(4, '\0') + message);
}

std::optional<std::string> PageClient::receive() {
  for (;;) {
    const std::string head = raw_.receive(2);
    if (head.size() < 2) return std::nullopt;
    const int kind = head[0] & 0x0f, length = head[1] & 0x7f;
    const std::size_t size =
        length < 126 ? static_cast<std::size_t>(length) : number(raw_.receive(length == 126 ? 2 : 8));
    std::string message = raw_.receive(size);
    if (kind == 1 || kind == 2) return message;
    if (kind == 8) return std::nullopt;
    if (kind == 9) send(message, 10);
  }
}

Json PageClient::call(const std::string& name, Json arguments) {
  const int id = ++last_id_;
  send(arguments.set("id", id).set("call", name).text(-1));
  while (const auto text = receive()) {
    Json message = Json::parse(*text);
    const Json* answered = message.find("id");
    if (answered && answered->as_number() == id) return message;
    kept_.push_back(std::move(message));
  }
  return {};
}

std::optional<Json> PageClient::news(const std::string& name) {
  const auto is_it = [&](const Json& one) {
    const Json* found = one.find("news");
    return found && found->as_text() && *found->as_text() == name;
  };
  for (;;) {
    const auto found = std::ranges::find_if(kept_, is_it);
    if (found != kept_.end()) {
      Json news = *found;
      kept_.erase(found);
      return news;
    }
    const auto text = receive();
    if (!text) return std::nullopt;
    kept_.push_back(Json::parse(*text));
  }
}

}  // namespace stepwire
