#include <catch2/catch.hpp>
#include <random>

#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

std::string repeat(const std::string& piece, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += piece;
  return text;
}

/// Refused with 2, with one line or more that name the file, within seconds and little memory.
Done refused(const std::string& text, const std::string& part, int code = 2) {
  const Scratch folder;
  folder.file("a.yaml", text);
  const Done done = run_program(folder, {"check", "a.yaml"});
  INFO(done.err.substr(0, 2000));
  CHECK(done.code == code);
  CHECK(done.out.empty());
  CHECK_THAT(done.err, Catch::StartsWith("a.yaml:"));
  CHECK_THAT(done.err, Contains(part));
  CHECK(done.seconds < 5.0);  // alone it is below one; the machine may be busy
  CHECK(done.megabytes < 500.0);
  return done;
}

std::string with(const std::string& more, const std::string& head = "step: 1 ms\nstop: 1 s\n") {
  return "stepwire: 1\ntitle: bad\n" + head + more;
}

}  // namespace

TEST_CASE("texts that are too deep, too large or no text are refused") {
  std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 20; ++i)
    bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" +
            repeat("*a" + std::to_string(i - 1) + ", ", 8) + "x]\n";
  refused(bomb, "aliases expanded");
  refused(repeat("[", 10'000) + repeat("]", 10'000), "nested deeper");
  refused(repeat("- ", 10'000) + "x", "nested deeper");
  std::mt19937 random(1);
  std::string noise(100'000, ' ');
  for (char& c : noise) c = static_cast<char>(random());
  refused(noise, "a.yaml:1:");
  refused("", "a.yaml:1:1: ");
}

TEST_CASE("a file above 8 MB is refused by its size unless --large is given") {
  const Scratch folder;
  folder.file(
      "a.yaml",
      lag_yaml + repeat("# a long comment that goes on and on and on and on and on and on\n", 140'000));
  const Done done = run_program(folder, {"check", "a.yaml"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains("a.yaml: the file has 8.") && Contains("at most 8.0 MB"));
  CHECK(run_program(folder, {"check", "a.yaml", "--large"}).code == 0);
}

TEST_CASE("double and unknown keys are refused with their places") {
  refused(with("step: 2 ms\nblocks: {a: {block: Clock}}\n"),
          "a.yaml:5:1: 'step' is given twice, first at 3:1; leave one out");
  refused(with("blocks: {a: {block: Clock}}\ncolour: red\n"), "a.yaml:6:1: a diagram has no 'colour'");
}

TEST_CASE("numbers that are none are refused") {
  for (const std::string number : {".nan", ".inf", "-.inf", "1e999", "= 1/0", "= 0/0"})
    refused(with("blocks:\n  a: {block: Constant, value: " + number + "}\n"), "a.yaml:6:31: ");
  refused(with("blocks: {a: {block: Clock}}\n", "step: -1 ms\nstop: 1 s\n"),
          "a.yaml:3:7: step: -1 ms is not allowed; it must be above 0");
  refused(with("blocks: {a: {block: Clock}}\n", "step: .nan\nstop: 1 s\n"), "a.yaml:3:7: step: ");
  refused(with("blocks: {a: {block: Clock}}\n", "step: 1 ms\nstop: .inf\n"), "a.yaml:4:7: stop: ");
  refused(with("blocks: {a: {block: Clock}}\n", "step: 1e-300 s\nstop: 1e300 s\n"), "stop: ");
  refused(with("blocks:\n  a: {block: Clock}\n  b: {block: UnitDelay, u: a, every: 1e300 s}\n"), "b.every: ");
}

TEST_CASE("files that use each other in a circle are refused with the way round") {
  const Scratch folder;
  const std::string head = "stepwire: 1\ntitle: x\nstep: 1 ms\nstop: 1 s\nblocks:\n";
  folder.file("a.yaml", head + "  b: {diagram: b.yaml}\n");
  folder.file("b.yaml", head + "  a: {diagram: ./a.yaml}\n");
  folder.file("self.yaml", head + "  s: {diagram: ../" +
                               std::filesystem::path(folder.path("")).parent_path().filename().string() +
                               "/self.yaml}\n");
  Done done = run_program(folder, {"check", "a.yaml"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains("b.yaml:6:16: ") && Contains("a.yaml -> b.yaml -> a.yaml") &&
                           Contains("(used by a.yaml:6:16)"));
  done = run_program(folder, {"check", "self.yaml"});
  CHECK(done.code == 2);
  CHECK(done.seconds < 5.0);
}

TEST_CASE("few files that make many parts of each other are refused") {
  const Scratch folder;
  const std::string head = "stepwire: 1\ntitle: x\nstep: 1 ms\nstop: 1 s\nblocks:\n";
  for (int i = 0; i < 30; ++i) {
    const std::string next = "{diagram: f" + std::to_string(i + 1) + ".yaml}\n";
    folder.file("f" + std::to_string(i) + ".yaml", head + "  a: " + next + "  b: " + next);
  }
  folder.file("f30.yaml", head + "  a: {block: Clock}\n");
  const Done done = run_program(folder, {"check", "f0.yaml"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains("more than 100000 parts"));
  CHECK(lines_of(done.err).size() == 1);
  CHECK(done.seconds < 20.0);
  CHECK(done.megabytes < 2000.0);
}

TEST_CASE("a part that is no file is refused at once") {
  const auto part = [](const std::string& path) { return with("blocks:\n  a: {diagram: " + path + "}\n"); };
  refused(part("none.yaml"), "a.yaml:6:16: a: none.yaml: no such file");
  refused(part("../.."), "this is a folder");
  refused(part("/dev/zero"), "is no file");
  refused(part("\"\""), "a.yaml:6:16: a: ");
  refused(part(repeat("x", 100'000)), "a.yaml:6:16: a: ");
}

TEST_CASE("sizes that no memory holds are refused before they are taken") {
  const std::string clock = "blocks:\n  t: {block: Clock}\n";
  refused(with(clock + "  d: {block: Delay, u: t, delay: 1e6 s}\n"),
          "a.yaml:7:6: d: needs more than 67108864 numbers");
  refused(with(clock + "  d: {block: Delay, u: t, delay: 1e280 s}\n"), "a.yaml:7:");
  refused(with(clock + "  d: {block: MovingAverage, u: t, window: 1e9 s}\n"), "a.yaml:7:");
  std::string doubling = clock + "  m0: {block: Mux, u: [t, t]}\n";
  for (int i = 1; i < 80; ++i) {
    const std::string before = "m" + std::to_string(i - 1);
    doubling += "  m" + std::to_string(i) + ": {block: Mux, u: [" + before + ", " + before + "]}\n";
  }
  refused(with(doubling), "67108864");
  refused(with(clock + "record: [t]\n", "step: 1 ms\nstop: 1e12 s\n"),
          "record: 1e+15 rows with 2e+15 numbers take about 3.2e+07 GB", 3);
  const std::string range = "{from: 0, to: 1, count: 60000}";
  refused(
      with("blocks:\n  a: {block: Constant, value: 1}\nsweep: {a.value: " + range + ", b: " + range + "}\n"),
      "makes 3600000000 runs");
  refused(
      with("blocks:\n  a: {block: Constant, value: 1}\nsweep: {a.value: {from: 0, to: 1, count: 1e12}}\n"),
      "'count' must be a whole number");
}

TEST_CASE("very long names are refused or taken, never a fall") {
  const Scratch folder;
  const std::string name = repeat("n", 1'000'000);
  folder.file("a.yaml", with("blocks:\n  " + name + ": {block: Clock}\nrecord: [" + name + "x]\n"));
  const Done done = run_program(folder, {"check", "a.yaml"});
  CHECK(done.code == 2);
  CHECK(done.seconds < 5.0);
  CHECK(done.megabytes < 500.0);
}
