#include "engine/base/messages/worker_process.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <thread>

#include "engine/base/io/environment_error.hpp"
#include "engine/base/messages/bytes.hpp"

namespace stepwire::messages {

namespace {

constexpr std::chrono::seconds longest{20};

/// Sends back what comes, until "end".
[[noreturn]] void echo(Connection& other) {
  std::signal(SIGTERM, SIG_DFL);  // the default action, not the handler of the tests
  while (const auto message = other.receive(longest)) {
    if (*message == "end") ::_exit(0);
    if (*message == "fail") ::_exit(7);
    other.send(*message);
  }
  ::_exit(1);
}

std::optional<std::string> death_of(WorkerProcess& worker) {
  for (int i = 0; i < 1000; ++i, std::this_thread::sleep_for(std::chrono::milliseconds{5}))
    if (auto how = worker.death()) return how;
  return std::nullopt;
}

}  // namespace

TEST_CASE("a worker gets messages whole and in their order, also large and empty ones") {
  WorkerProcess worker;
  if (worker.is_worker()) echo(worker.other());
  const std::string large(3'000'000, 'x');
  for (const std::string& text : {std::string("one"), std::string(), large, std::string("a\0b", 3)}) {
    worker.other().send(text);
    CHECK(worker.other().receive(longest) == text);
  }
  CHECK_FALSE(worker.other().receive(std::chrono::milliseconds{5}));
  CHECK_FALSE(worker.death());
}

TEST_CASE("how a worker died is known, and that it has gone") {
  for (const bool killed : {true, false}) {
    WorkerProcess worker;
    if (worker.is_worker()) echo(worker.other());
    if (killed)
      ::kill(worker.process(), SIGKILL);
    else
      worker.other().send("fail");
    CHECK(death_of(worker) == (killed ? "signal 9" : "status 7"));
    CHECK_THROWS_AS(worker.other().receive(longest), io::EnvironmentError);
  }
}

TEST_CASE("of bytes that were cut off nothing but zeros is read, and that is known") {
  ByteWriter writer;
  std::vector<std::string> texts{"one", "two"};
  std::vector<double> numbers{1.5, -0.0};
  plain_list(writer, texts);
  plain_list(writer, numbers);
  const std::string bytes = writer.take();
  for (std::size_t size = 0; size <= bytes.size(); ++size) {
    ByteReader reader(std::string_view(bytes).substr(0, size));
    std::vector<std::string> read;
    std::vector<double> values;
    plain_list(reader, read);
    plain_list(reader, values);
    CHECK(reader.whole() == (size == bytes.size()));
    if (reader.whole()) CHECK((read == texts && values == numbers));
  }
}

}  // namespace stepwire::messages
