#include <catch2/catch.hpp>
#include <thread>

#include "tests/engine/app/studio/echo_site.hpp"

namespace stepwire::http {

using Catch::Contains;
using std::chrono::milliseconds;

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
    CHECK(served.site.wait_until([&] { return served.site.open == std::set<int>{1}; }));
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

TEST_CASE("connections that say nothing are closed in time") {
  Limits limits;
  limits.handshake = milliseconds(200);
  const Served served(limits);
  std::vector<std::unique_ptr<RawClient>> silent;
  for (int i = 0; i < 4; ++i) silent.push_back(std::make_unique<RawClient>(served.key().port));
  for (const auto& one : silent) CHECK(one->is_closed_within(milliseconds(5000)));
}

TEST_CASE("of too many connections the one that has said nothing for longest makes room at once") {
  Limits limits;
  limits.connections = 4;
  limits.handshake = std::chrono::minutes(10);  // so that none is closed for its silence alone
  const Served served(limits);
  std::vector<std::unique_ptr<RawClient>> silent;
  for (int i = 0; i < 8; ++i) silent.push_back(std::make_unique<RawClient>(served.key().port));
  CHECK_THAT(answer_to(served.key(), served.head("/", "Connection: close\r\n")), Contains("the page"));
  for (std::size_t i = 0; i < 5; ++i) CHECK(silent[i]->is_closed_within(milliseconds(5000)));
  for (std::size_t i = 5; i < 8; ++i) CHECK_FALSE(silent[i]->is_closed_within(milliseconds(20)));
}

TEST_CASE("connections that wait in the middle of a request make room, pages do not") {
  Limits limits;
  limits.connections = 3;
  limits.handshake = std::chrono::minutes(10);
  const Served served(limits);
  PageClient page(served.key());
  REQUIRE(page.is_open());
  RawClient slow(served.key().port), other(served.key().port);
  slow.send("GET / HTTP/1.1\r\nHost");
  CHECK_THAT(answer_to(served.key(), served.head("/", "Connection: close\r\n")), Contains("the page"));
  CHECK(slow.is_closed_within(milliseconds(5000)));
  page.send("still there");
  CHECK(page.receive() == "still there");
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

TEST_CASE("a page that sends and does not read is not read on until it reads, and then nothing is lost") {
  Limits limits;
  limits.unread = 100'000;
  limits.unsent = 1 << 30;
  Served served(limits);
  PageClient page(served.key());
  REQUIRE(page.is_open());
  constexpr std::size_t size = 50'000, count = 1000;  // more than the buffers of both ends of the system hold
  std::thread flood([&] {
    for (std::size_t i = 0; i < count; ++i) page.send(std::string(size, 'x'));
  });
  REQUIRE(served.site.wait_until([&] { return served.site.bytes >= limits.unread; }));
  std::this_thread::sleep_for(milliseconds(200));
  {
    const std::lock_guard lock(served.site.mutex);
    CHECK(served.site.bytes < size * count / 2);
  }
  PageClient other(served.key());
  other.send("alive");
  CHECK(other.receive() == "alive");
  for (std::size_t i = 0; i < count; ++i) REQUIRE(page.receive() == std::string(size, 'x'));
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

TEST_CASE("a page has left once its socket is closed, though what it said is still worked on") {
  Served served;
  served.site.keeps = true;
  auto page = std::make_unique<PageClient>(served.key());
  REQUIRE(page->is_open());
  page->send("takes long");
  REQUIRE(served.site.wait_until([&] { return served.site.tickets.size() == 1; }));
  page.reset();
  CHECK(served.site.wait_until([&] { return served.site.open.empty(); }));
  const std::lock_guard lock(served.site.mutex);
  CHECK(served.site.tickets.size() == 1);
}

}  // namespace stepwire::http
