#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <thread>

#include "tests/engine/app/cli/program.hpp"

using Catch::Matchers::Contains;

namespace {

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

/// Waits until a file contains a word exactly `times` times; returns false after a minute.
bool comes(const std::string& file, const std::string& word, std::size_t times = 1) {
  for (int i = 0; i < 600; ++i) {
    if (count(content_of(file), word) == times) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return false;
}

const std::string part =
    "stepwire: 1\ntitle: p\ninputs: {x: }\noutputs: {y: k}\nblocks:\n  k: {block: Gain, gain: 2, u: x}\n";

}  // namespace

TEST_CASE("check --watch checks again when a part changes, also when an editor renames a file over it") {
  const Scratch folder;
  folder.file("part.yaml", part);
  folder.file("a.yaml",
              "stepwire: 1\ntitle: t\nstep: 1 ms\nstop: 1 s\nrecord: [rig]\nblocks:\n  one: {block: "
              "Constant, value: 1}\n"
              "  rig: {diagram: part.yaml, x: one}\n");
  Call call{{"check", "--watch", folder.path("a.yaml")}, {}};
  call.out_to = folder.path("out");
  call.err_to = folder.path("err");
  call.interrupt_when = folder.path("end");
  bool first = false, wrong = false, right = false;
  std::thread editor([&] {
    first = comes(call.out_to, "nothing wrong");
    folder.file("other.yaml", "stepwire: 1\nblocks:\n  k: {block: Gian}\n");
    std::filesystem::rename(folder.path("other.yaml"), folder.path("part.yaml"));
    wrong = comes(call.err_to, "there is no block 'Gian'; did you mean 'Gain'?");
    folder.file("part.yaml", part + "# mended\n");
    right = comes(call.out_to, "nothing wrong", 2) && comes(call.out_to, "a.yaml: not right");
    folder.file("end", "");
  });
  const Done done = run_program(folder, call);
  editor.join();
  CHECK((first && wrong && right));
  CHECK(done.code == 130);
}
