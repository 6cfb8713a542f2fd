#include "engine/app/studio/http/http_server.hpp"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <ctime>
#include <thread>

#include "engine/app/studio/http/loopback.hpp"
#include "tests/engine/app/studio/echo_site.hpp"

namespace stepwire::http {

namespace {

using Catch::Contains;
using std::chrono::milliseconds;

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
  Limits limits;
  limits.handshake = milliseconds(200);  // a body that never comes is not awaited for longer
  const Served served(limits);
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

TEST_CASE("where no descriptor is left a server waits for one, and does not go round") {
  const Served served;
  rlimit before{};
  ::getrlimit(RLIMIT_NOFILE, &before);
  const int lowest = ::dup(0);
  ::close(lowest);
  rlimit tight = before;
  tight.rlim_cur = static_cast<rlim_t>(lowest) + 1;
  ::setrlimit(RLIMIT_NOFILE, &tight);
  RawClient client(served.key().port);  // takes the last one
  const std::clock_t start = std::clock();
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  const double spent = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  ::setrlimit(RLIMIT_NOFILE, &before);
  CHECK(spent < 0.1);
  client.send(served.head("/").text());
  CHECK_THAT(client.receive_until("\r\n"), Contains("200 OK"));
}

}  // namespace stepwire::http
