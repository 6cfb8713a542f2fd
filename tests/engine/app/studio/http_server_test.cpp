#include "engine/app/studio/http/http_server.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <catch2/catch.hpp>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <set>

#include "engine/app/studio/http/loopback.hpp"
#include "engine/base/io/environment_error.hpp"
#include "tests/engine/app/studio/raw_client.hpp"

namespace stepwire::http {

namespace {

using Catch::Contains;
using std::chrono::milliseconds;

/// Serves "/" and "/a.js", and a socket that gives every message back.
class EchoSite : public Site {
 public:
  Answer answer(const Request&, const std::string& path) override {
    if (path == "/") return {200, {{"Content-Type", "text/html"}}, "the page"};
    if (path == "/a.js") return {200, {}, "", "fixed"};
    return {404};
  }
  bool has_socket(const std::string& path) override { return path == "/socket"; }
  void joined(int page) override {
    change([&] { open.insert(page); });
  }
  void left(int page) override {
    change([&] { open.erase(page); });
  }
  void said(int page, std::string message, Ticket ticket) override {
    change([&] {
      bytes += message.size();
      if (keeps) tickets.push_back(std::move(ticket));
    });
    if (!keeps) server->send_text(page, std::move(message));
  }
  template <class Condition>
  bool wait_until(Condition condition) {
    std::unique_lock lock(mutex);
    return changed.wait_for(lock, std::chrono::seconds(5), condition);
  }

  HttpServer* server = nullptr;
  bool keeps = false;  ///< tickets; then nothing is given back
  std::mutex mutex;
  std::condition_variable changed;
  std::set<int> open;
  std::size_t bytes = 0;
  std::vector<Ticket> tickets;

 private:
  template <class Action>
  void change(Action action) {
    const std::lock_guard lock(mutex);
    action();
    changed.notify_all();
  }
};

/// A server that is gone after the test.
struct Served {
  explicit Served(Limits limits = {}) : server(listen(site, 0, limits)) {
    site.server = server.get();
    server->start();
  }
  ~Served() {
    server->stop();
    site.tickets.clear();
  }
  const Key& key() const { return server->key(); }
  Head head(const std::string& target, const std::string& more = {}) const {
    return {"GET", target, host_of(key()), cookie_line(key()) + more};
  }

  EchoSite site;
  std::unique_ptr<HttpServer> server;
};

const std::vector<std::string> routes{"/", "/a.js", "/socket", "/index.html", "/nothing", "/../a.js"};

/// The status and no body: the head ends the answer.
bool is_refused(const std::string& answer) {
  return answer.starts_with("HTTP/1.1 403 ") && answer.ends_with("\r\n\r\n") &&
         answer.find("Content-Length: 0\r\n") != std::string::npos;
}

std::string socket_lines(const Key& key, const std::string& origin) {
  return "Origin: " + origin + "\r\n" + cookie_line(key) + upgrade_lines;
}

}  // namespace

TEST_CASE("the server listens at the loopback addresses alone, at one port") {
  const Served served;
  const std::uint16_t port = served.key().port;
  CHECK(RawClient(port).is_connected());
  CHECK((!listen_on_loopback(0).v6.open() || RawClient(port, true).is_connected()));
  ifaddrs* all = nullptr;
  REQUIRE(::getifaddrs(&all) == 0);
  for (const ifaddrs* one = all; one; one = one->ifa_next) {
    if (!one->ifa_addr || one->ifa_addr->sa_family != AF_INET) continue;
    sockaddr_in address = *reinterpret_cast<const sockaddr_in*>(one->ifa_addr);
    if (ntohl(address.sin_addr.s_addr) >> 24 == 127) continue;
    address.sin_port = htons(port);
    const io::Descriptor socket(::socket(AF_INET, SOCK_STREAM, 0));
    CHECK(::connect(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0);
  }
  ::freeifaddrs(all);
  CHECK_THROWS_WITH(listen_on_loopback(port), Contains("is taken"));
}

TEST_CASE("every route refuses who has no token, another Host or another Origin, in the same words") {
  const Served served;
  const Key& key = served.key();
  const std::string ours = "http://" + host_of(key);
  for (const std::string& route : routes) {
    INFO(route);
    CHECK(is_refused(answer_to(key, {"GET", route, host_of(key)})));
    CHECK(is_refused(answer_to(key, {"GET", route + "?token=" + std::string(32, '0'), host_of(key)})));
    CHECK(is_refused(answer_to(key, {"GET", route, "evil.example", cookie_line(key)})));
    CHECK(is_refused(answer_to(key, {"GET", route, "", cookie_line(key)})));
    CHECK(is_refused(answer_to(key, {"POST", route, host_of(key), cookie_line(key)})));
    CHECK(is_refused(answer_to(key, served.head(route, "Origin: http://evil.example\r\n"))));
    CHECK(is_refused(answer_to(key, served.head(route, "Origin: null\r\n"))));
    for (const std::string& origin : std::vector<std::string>{"http://evil.example", "null"})
      CHECK(is_refused(answer_to(key, {"GET", route, host_of(key), socket_lines(key, origin)})));
    CHECK(
        is_refused(answer_to(key, {"GET", route, host_of(key), "Origin: " + ours + "\r\n" + upgrade_lines})));
    CHECK(
        is_refused(answer_to(key, {"GET", route, "evil.example", socket_lines(key, "http://evil.example")})));
  }
}

TEST_CASE("the address with the token leads to the page without it, by a cookie that scripts cannot read") {
  const Served served;
  const Key& key = served.key();
  const std::string answer = answer_to(key, {"GET", "/?token=" + key.token, host_of(key)});
  CHECK(answer.starts_with("HTTP/1.1 303 "));
  CHECK_THAT(answer, Contains("Location: /\r\n"));
  CHECK_THAT(answer, Contains("Set-Cookie: " + cookie_name(key) + "=" + key.token +
                              "; HttpOnly; SameSite=Strict; Path=/\r\n"));
  CHECK_THAT(answer_to(key, served.head("/")), Contains("the page"));
  CHECK_THAT(answer_to(key, served.head("/a.js")), Contains("fixed"));
  CHECK(answer_to(key, served.head("/../a.js")).starts_with("HTTP/1.1 404 "));
}

TEST_CASE("what is no GET gets nothing, and a body nobody reads") {
  const Served served;
  const Key& key = served.key();
  const std::string ours = "Origin: http://" + host_of(key) + "\r\n" + cookie_line(key);
  for (const std::string& method :
       std::vector<std::string>{"POST", "PUT", "DELETE", "OPTIONS", "PATCH", "TRACE", "PROPFIND"})
    CHECK(answer_to(key, {method, "/", host_of(key), ours}).starts_with("HTTP/1.1 405 "));
  const std::string head = answer_to(key, {"HEAD", "/", host_of(key), ours});
  CHECK_THAT(head, Contains("Content-Length: 8\r\n"));
  CHECK(head.ends_with("\r\n\r\n"));
  CHECK(answer_to(key, served.head("/", "Content-Length: 1\r\n")).empty());
  CHECK(answer_to(key, served.head("/", "Content-Length: 9000000000\r\n")).empty());
  CHECK(answer_to(key, served.head("/", "Transfer-Encoding: chunked\r\n")).find("the page") ==
        std::string::npos);
}

TEST_CASE("a head beyond 8 kB, or one that does not come to its end, closes the connection") {
  Limits limits;
  limits.handshake = milliseconds(200);
  const Served served(limits);
  const Key& key = served.key();
  CHECK(answer_to(key, served.head("/", "X: " + std::string(9000, 'x') + "\r\n")).empty());
  CHECK_FALSE(answer_to(key, served.head("/", "X: " + std::string(6000, 'x') + "\r\n")).empty());
  RawClient slow(key.port);
  slow.send("GET / HTTP/1.1\r\nHost");
  CHECK(slow.is_closed_within(milliseconds(5000)));
  RawClient silent(key.port);
  CHECK(silent.is_closed_within(milliseconds(5000)));
}

TEST_CASE("what is no HTTP gets nothing") {
  const Served served;
  for (const std::string& text : std::vector<std::string>{
           "\r\n\r\n\r\n", "GET\r\n\r\n", "GET / HTTP/9.9\r\n\r\n", "\x16\x03\x01\x02\x00",
           "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n", "GET / HTTP/1.1\r\nHost : 127.0.0.1\r\n\r\n",
           "GET / HTTP/1.1\r\n\x01: a\r\n\r\n"}) {
    RawClient client(served.key().port);
    client.send(text + std::string("\r\n\r\n"));
    const std::string answer = client.receive_all();
    CHECK((answer.empty() || is_refused(answer)));
  }
}

TEST_CASE("a page's socket gives messages in both directions, and the site sees it come and go") {
  Served served;
  {
    PageClient page(served.key());
    REQUIRE(page.is_open());
    for (const std::size_t size : {0u, 5u, 125u, 126u, 65535u, 65536u, 1000000u}) {
      page.send(std::string(size, 'x'));
      CHECK(page.receive() == std::string(size, 'x'));
    }
    served.server->send_bytes(1, std::string("\0\xff", 2));
    CHECK(page.receive() == std::string("\0\xff", 2));
    served.server->send_text(2, "nobody");
    CHECK(served.site.open == std::set<int>{1});
  }
  CHECK(served.site.wait_until([&] { return served.site.open.empty(); }));
}

TEST_CASE(
    "a message beyond a megabyte, bytes where text belongs, or text that is no UTF-8 closes the socket") {
  const Served served;
  for (const auto& [message, kind] : {std::pair{std::string((1 << 20) + 1, 'x'), 1},
                                      {std::string("x"), 2},
                                      {std::string("\xff\xfe"), 1},
                                      {std::string("x"), 3},
                                      {std::string("x"), 11}}) {
    PageClient page(served.key());
    REQUIRE(page.is_open());
    page.send(message, kind);
    CHECK_FALSE(page.receive());
  }
}

TEST_CASE("frames that break the rules of RFC 6455 close the socket") {
  const Served served;
  const std::string no_mask("\x81\x01x", 3), reserved("\xf1\x80\0\0\0\0", 6),
      long_ping("\x89\xfe\0\xff\0\0\0\0", 8), huge("\x81\xff\xff\xff\xff\xff\xff\xff\xff\xff\0\0\0\0", 14),
      rest("\x80\x81\0\0\0\0x", 7);
  for (const std::string& bytes : {no_mask, reserved, long_ping, huge, rest}) {
    PageClient page(served.key());
    REQUIRE(page.is_open());
    page.raw().send(bytes);
    CHECK(page.raw().is_closed_within(milliseconds(5000)));
  }
}

TEST_CASE("sixteen pages at a time, and a place is free when one goes") {
  Served served;
  std::vector<std::unique_ptr<PageClient>> pages;
  for (int i = 0; i < 16; ++i) {
    pages.push_back(std::make_unique<PageClient>(served.key()));
    CHECK(pages.back()->is_open());
  }
  CHECK_FALSE(PageClient(served.key()).is_open());
  pages.pop_back();
  CHECK(served.site.wait_until([&] { return served.site.open.size() == 15; }));
  CHECK(PageClient(served.key()).is_open());
}

TEST_CASE("connections that say nothing leave room for those that are left after them") {
  Limits limits;
  limits.connections = 4;
  limits.handshake = milliseconds(200);
  const Served served(limits);
  std::vector<std::unique_ptr<RawClient>> silent;
  for (int i = 0; i < 8; ++i) silent.push_back(std::make_unique<RawClient>(served.key().port));
  for (const auto& one : silent) CHECK(one->is_closed_within(milliseconds(5000)));
  CHECK_THAT(answer_to(served.key(), served.head("/")), Contains("the page"));
}

TEST_CASE("a page that answers no ping is closed, one that does is not") {
  Limits limits;
  limits.ping = milliseconds(100);
  Served served(limits);
  PageClient deaf(served.key()), living(served.key());
  REQUIRE(deaf.is_open());
  REQUIRE(living.is_open());
  std::thread hears([&] { living.receive(); });
  CHECK(deaf.raw().is_closed_within(milliseconds(5000)));
  CHECK(served.site.wait_until([&] { return !served.site.open.contains(1); }));
  {
    const std::lock_guard lock(served.site.mutex);
    CHECK(served.site.open == std::set<int>{2});
  }
  served.server->send_text(2, "still there");
  hears.join();
}

TEST_CASE("a page that floods is not read on until its messages are done") {
  Limits limits;
  limits.waiting = 100'000;
  Served served(limits);
  served.site.keeps = true;
  PageClient page(served.key());
  REQUIRE(page.is_open());
  std::thread flood([&] {
    for (int i = 0; i < 400; ++i) page.send(std::string(50'000, 'x'));
  });
  REQUIRE(served.site.wait_until([&] { return served.site.bytes >= 100'000; }));
  std::this_thread::sleep_for(milliseconds(100));
  {
    const std::lock_guard lock(served.site.mutex);
    CHECK(served.site.bytes <= 150'000);
  }
  for (std::size_t all = 0; all < 400 * 50'000;) {
    std::vector<Ticket> done;
    REQUIRE(served.site.wait_until([&] { return !served.site.tickets.empty(); }));
    const std::lock_guard lock(served.site.mutex);
    done.swap(served.site.tickets);
    all = served.site.bytes;
  }
  flood.join();
}

TEST_CASE("a page that reads nothing is closed, and what waits for it is bounded") {
  Limits limits;
  limits.unsent = 1'000'000;
  Served served(limits);
  PageClient stalled(served.key()), other(served.key());
  REQUIRE(stalled.is_open());
  for (int i = 0; i < 400; ++i) served.server->send_bytes(1, std::string(100'000, 'x'));
  CHECK(served.site.wait_until([&] { return !served.site.open.contains(1); }));
  other.send("alive");
  CHECK(other.receive() == "alive");
}

}  // namespace stepwire::http
