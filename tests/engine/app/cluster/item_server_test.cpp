#include "engine/app/cluster/item_server.hpp"

#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <thread>

#include "engine/app/cluster/item_client.hpp"
#include "engine/app/cluster/item_messages.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/messages/bytes.hpp"

using Catch::Contains;

namespace stepwire::cluster {

namespace {

using messages::all;

/// A mailbox: a queue of messages for one receiver.
class Box {
 public:
  void put(messages::Message message) {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(message));
    came_.notify_one();
  }
  std::optional<messages::Message> take(std::chrono::milliseconds wait) {
    std::unique_lock lock(mutex_);
    if (!came_.wait_for(lock, wait, [&] { return !waiting_.empty(); })) return std::nullopt;
    messages::Message first = std::move(waiting_.front());
    waiting_.pop_front();
    return first;
  }

 private:
  std::mutex mutex_;
  std::condition_variable came_;
  std::deque<messages::Message> waiting_;
};

/// Threads in the place of processes.
class Threads : public messages::Messages {
 public:
  explicit Threads(int size) : boxes(static_cast<std::size_t>(size)) {}
  int rank() const override { return 0; }
  int size() const override { return static_cast<int>(boxes.size()); }
  void send(int to, std::string_view bytes) override {
    boxes[static_cast<std::size_t>(to)].put({0, std::string(bytes)});
  }
  std::optional<messages::Message> receive(std::chrono::milliseconds wait) override {
    return boxes[0].take(wait);
  }
  void finish() override {}
  [[noreturn]] void abort(int) override { throw std::logic_error("nobody aborts here"); }

  std::vector<Box> boxes;
};

/// The other end of one of them.
class Other : public messages::Connection {
 public:
  Other(Threads& threads, int rank) : all_(threads), rank_(rank) {
    messages::ByteWriter writer;
    const std::int64_t process = ::getpid();
    all(writer, kind::hello, process, this_host());
    send(writer.take());
  }
  void send(std::string_view bytes) override { all_.boxes[0].put({rank_, std::string(bytes)}); }
  std::optional<std::string> receive(std::chrono::milliseconds wait) override {
    auto message = all_.boxes[static_cast<std::size_t>(rank_)].take(wait);
    if (message && message->bytes.front() == kind::end) send(std::string(1, kind::bye));
    return message ? std::optional(message->bytes) : std::nullopt;
  }

 private:
  Threads& all_;
  int rank_;
};

/// Numbers whose squares are looked for.
class Squares : public ItemSource {
 public:
  explicit Squares(std::size_t count) : count_(count) {}
  std::optional<messages::Item> next() override {
    if (next_ == count_) return std::nullopt;
    const std::size_t number = next_++;
    return messages::Item{number, std::to_string(3 * number)};
  }
  std::size_t left() const override { return count_ - next_; }
  void take(std::size_t number, std::string_view bytes) override {
    CHECK_FALSE(found.contains(number));
    found[number] = std::string(bytes);
  }
  double done() const override { return 0.0; }

  std::map<std::size_t, std::string> found;

 private:
  std::size_t count_, next_ = 0;
};

std::string square_of(const messages::Item& item) {
  const long number = std::stol(item.bytes);
  return std::to_string(number * number);
}

/// Processes items until there are no more jobs; after `most` items it reports its death instead.
void work(Threads& threads, int rank, std::size_t most = 1'000'000) {
  Other other(threads, rank);
  ItemClient client(other);
  while (const auto job = client.next_job())
    while (const auto item = client.next()) {
      if (most-- == 0) return other.send(kind::died + std::string("signal 9"));
      client.put(item->number, square_of(*item));
    }
}

}  // namespace

TEST_CASE("items of several jobs are done once each, by whoever asks") {
  constexpr std::size_t count = 5000;
  Threads threads(4);
  std::vector<std::jthread> others;
  for (int rank = 1; rank < 4; ++rank) others.emplace_back([&, rank] { work(threads, rank); });
  ItemServer server(threads);
  for (int job = 0; job < 3; ++job) {
    Squares squares(count);
    server.serve(squares, "squares", {});
    REQUIRE(squares.found.size() == count);
    for (std::size_t number = 0; number < count; ++number)
      CHECK(squares.found[number] == std::to_string(9 * number * number));
  }
  CHECK(server.finish());
  CHECK(server.deaths().empty());
}

TEST_CASE("what died takes with it what it was given, and no more; the others do the rest") {
  constexpr std::size_t count = 300;
  Threads threads(3);
  std::vector<std::jthread> others;
  others.emplace_back([&] { work(threads, 1); });
  others.emplace_back([&] { work(threads, 2, 20); });
  ItemServer server(threads);
  Squares squares(count);
  server.serve(squares, "squares", {});
  REQUIRE(server.deaths().size() <= 1);
  if (server.deaths().empty()) {
    CHECK(squares.found.size() == count);  // the first one has done it all
  } else {
    CHECK_THAT(server.deaths().front(),
               Contains("process 2 on " + this_host() + " has died (signal 9), and with it " +
                        std::to_string(count - squares.found.size()) + " of what it was given"));
  }
  threads.boxes[0].put({2, std::string(1, kind::bye)});
  CHECK(server.finish());
}

TEST_CASE("where all have died the call ends with what is there") {
  Threads threads(2);
  std::vector<std::jthread> others;
  others.emplace_back([&] { work(threads, 1, 9); });
  ItemServer server(threads);
  Squares squares(100);
  server.serve(squares, "squares", {});
  CHECK(squares.found.size() < 10);
  REQUIRE(server.deaths().size() == 1);
}

TEST_CASE("what an item is refused with comes to process 0 as it was thrown") {
  const yaml::Fault fault{{"lag.yaml", {7, 3}}, "lag.u", {"is wrong", "right it"}, {{"top.yaml", {1, 2}}}};
  Threads threads(2);
  std::vector<std::jthread> others;
  others.emplace_back([&] {
    Other other(threads, 1);
    ItemClient client(other);
    while (const auto job = client.next_job())
      while (const auto item = client.next()) client.refuse(yaml::Error(fault));
  });
  ItemServer server(threads);
  Squares squares(10);
  CHECK_THROWS_WITH(server.serve(squares, "squares", {}), fault.text());
  CHECK(server.finish());
}

}  // namespace stepwire::cluster
