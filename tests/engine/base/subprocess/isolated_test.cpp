#include "engine/base/subprocess/isolated.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <csignal>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "engine/base/subprocess/process.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::subprocess {

using Catch::Contains;

namespace {

const IsolationBounds usual{std::chrono::seconds(60), std::size_t{512} << 20};

std::string text_of(const io::Descriptor& file) {
  std::array<char, 100> text{};
  const ssize_t count = ::read(file.number(), text.data(), text.size());
  return {text.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))};
}

std::string trouble_of(const std::function<void(int)>& function, const IsolationBounds& bounds = usual) {
  try {
    call_isolated(function, bounds);
  } catch (const IsolationError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("What a function writes in a process of its own comes back, and what it changes does not") {
  int value = 1;
  const io::Descriptor output = call_isolated(
      [&](int file) {
        value = 2;
        CHECK(::write(file, "done", 4) == 4);
      },
      usual);
  CHECK(text_of(output) == "done");
  CHECK(value == 1);
}

TEST_CASE("A function that crashes, throws or ends its process is one sentence, and the others go on") {
  CHECK(trouble_of([](int) { std::raise(SIGSEGV); }) == "was ended by signal 11 (Segmentation fault)");
  CHECK_THAT(trouble_of([](int) { std::abort(); }), Contains("signal 6"));
  CHECK(trouble_of([](int) { ::_exit(7); }) == "has ended itself with status 7");
  CHECK_THAT(trouble_of([](int) { throw 1; }), Contains("has ended itself"));
}

TEST_CASE("A function that exits in a process of its own runs no handler of this process") {
  const Scratch scratch;
  static std::string path;
  path = scratch.path("handler has run");
  std::atexit([] {
    if (!path.empty()) std::ofstream(path) << "wrong";
  });
  CHECK(trouble_of([](int) { std::exit(4); }) == "has ended itself with status 4");
  CHECK_FALSE(std::filesystem::exists(path));
  path.clear();
}

TEST_CASE("A function that comes to no end is ended") {
  const IsolationBounds soon{std::chrono::milliseconds(100), usual.memory};
  const auto start = std::chrono::steady_clock::now();
  const auto hang = [](int) {
    while (true) ::pause();
  };
  CHECK_THAT(trouble_of(hang, soon), Contains("does not come to an end"));
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
}

TEST_CASE("A function that takes more memory than its bounds is ended") {
  const auto grow = [](int) {
    std::vector<std::vector<char>> all;
    while (true) all.emplace_back(std::size_t{16} << 20, 'x');
  };
  const std::string trouble = trouble_of(grow, {std::chrono::seconds(60), std::size_t{64} << 20});
  // Under a sanitizer the process ends itself where memory does.
  CHECK((trouble == "takes more than 64 MB of memory" || trouble.starts_with("has ended itself") ||
         trouble.starts_with("was ended by signal")));
}

TEST_CASE("A function in a process of its own prints nothing and sees no other file") {
  const Scratch scratch;
  const std::string path = scratch.file("open", "");
  const io::Descriptor open(::dup(2));
  REQUIRE(::freopen(path.c_str(), "w", stderr));
  const io::Descriptor output = call_isolated(
      [&](int file) {
        std::fputs("words of a library\n", stderr);
        std::fflush(stderr);
        const bool sees = ::fcntl(open.number(), F_GETFD) >= 0;
        CHECK(::write(file, sees ? "sees" : "none", 4) == 4);
      },
      usual);
  std::fflush(stderr);
  ::dup2(open.number(), 2);
  CHECK(text_of(output) == "none");
  CHECK(std::filesystem::file_size(path) == 0);
}

TEST_CASE("An interruption ends a function in a process of its own") {
  std::jthread interrupt([] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    processes_stop() = true;
  });
  const auto hang = [](int) {
    while (true) ::pause();
  };
  CHECK_THROWS_AS(call_isolated(hang, usual), ProcessStopped);
  processes_stop() = false;
}

}  // namespace stepwire::subprocess
