// Blocks of a folder outside of the library, as a call names it.
#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/engine/app/cli/program.hpp"

namespace {

const std::string header = R"(#pragma once
#include "law.hpp"
#include <stepwire/block.hpp>
namespace yard {
/// A gain of three.
struct Triple {
  stepwire::Input<1> u{};
  stepwire::Output<1> y{};
  void outputs() { y = tripled(u); }
  static void declare(stepwire::Declare<Triple>& is);
};
}
)";
const std::string source = R"(#include "triple.hpp"
#include <stepwire/declare.hpp>
namespace yard {
void Triple::declare(stepwire::Declare<Triple>& is) {
  is.block("NAME", {.doc = "Three times its input."});
  is.input<&Triple::u>({.unit = "'u", .doc = "signal"});
  is.output<&Triple::y>({.unit = "'u", .doc = "three times the signal"});
}
}
)";
const std::string registration = R"(#include <stepwire/registry.hpp>
#include "family/triple.hpp"
void register_blocks(stepwire::Registry& registry) { registry.add<yard::Triple>("yard"); }
)";
const std::string diagram = R"(stepwire: 1
step: 1 ms
stop: 0.1 s
solver: rk4
blocks:
  wave: {block: Sine, amplitude: 1 m, frequency: 3 Hz}
  more: {block: Triple, u: wave}
record: [wave, more]
claims:
  - {that: it is three times as much, max: abs(more - 3*wave), at_most: 0 m}
)";

/// A folder `own` with the block, and a diagram.
struct Outside : Scratch {
  explicit Outside(const std::string& name = "Triple") {
    std::filesystem::create_directories(path("own/family"));
    std::string declared = source;
    declared.replace(declared.find("NAME"), 4, name);
    file("own/family/law.hpp", "#pragma once\ninline double tripled(double u) { return 3.0 * u; }\n");
    file("own/family/triple.hpp", header);
    file("own/family/triple.cpp", declared);
    file("own/register.cpp", registration);
    file("wave.yaml", diagram);
  }
};

}  // namespace

TEST_CASE("blocks of a folder that the call names are known to every verb", "[full]") {
  const Outside folder;
  const Done unknown = run_program(folder, {"check", "wave.yaml"});
  CHECK(unknown.code == 2);
  CHECK(unknown.err.find("Triple") != std::string::npos);

  for (const std::string engine : {"interpreted", "compiled"}) {
    const Done run = run_program(
        folder, {"--blocks", "own", "run", "wave.yaml", "--engine", engine, "--out", "out/" + engine});
    INFO(run.err);
    CHECK(run.code == 0);
    CHECK(run.err.empty());
  }
  CHECK(content_of(folder.path("out/compiled/run.json")).find("\"compiled_ticks\": 100") !=
        std::string::npos);
  CHECK(content_of(folder.path("out/compiled/signals.csv")) ==
        content_of(folder.path("out/interpreted/signals.csv")));

  const auto succeeds = [&](const std::vector<std::string>& words, const std::string& shown) {
    const Done done = run_program(folder, words);
    INFO(words.front() << ": " << done.err);
    CHECK(done.code == 0);
    CHECK(done.out.find(shown) != std::string::npos);
  };
  succeeds({"verify", "out/compiled", "--blocks", "own"}, "all bits agree");
  succeeds({"blocks", "Triple", "--blocks=own"}, "Three times its input.");
  succeeds({"schema", "--blocks", "own"}, "Triple");
  succeeds({"draw", "wave.yaml", "--json", "--blocks", "own"}, "more");
  succeeds({"flatten", "wave.yaml", "--blocks", "own"}, "Triple");
  succeeds({"generate", "wave.yaml", "-o", "made", "--blocks", "own"}, "blocks written");
  CHECK(content_of(folder.path("made/wave.cpp")).find("family/triple.hpp\"") == std::string::npos);
  CHECK(content_of(folder.path("made/blocks_of_others/triple.hpp")) == header);
  CHECK(content_of(folder.path("made/blocks_of_others/law.hpp")).find("tripled") != std::string::npos);

  Call call{{"check", "wave.yaml"}, {{"STEPWIRE_BLOCKS", folder.path("own")}}};
  CHECK(run_program(folder, call).code == 0);
}

TEST_CASE("what is wrong with such blocks is told with file and line", "[full]") {
  const Outside folder("Gain");
  const Done twice = run_program(folder, {"check", "wave.yaml", "--blocks", "own"});
  CHECK(twice.code == 2);
  CHECK(twice.err.find(
            "own/family/triple.cpp:5: a block is called Gain already, that of blocks/math/gain.cpp:") !=
        std::string::npos);

  folder.file("own/family/law.hpp", "#pragma once\ninline double tripled(double u) { return 3.0 * v; }\n");
  const Done wrong = run_program(folder, {"check", "wave.yaml", "--blocks", "own"});
  CHECK(wrong.code == 2);
  CHECK(wrong.err.find("own/family/law.hpp:2:48: ") != std::string::npos);

  std::filesystem::create_directories(folder.path("empty"));
  CHECK(run_program(folder, {"blocks", "--blocks", "empty"}).err.find("there is no .cpp file") !=
        std::string::npos);
  CHECK(run_program(folder, {"blocks", "--blocks", "none"}).code == 3);
}

TEST_CASE("a folder whose sources register nothing is refused", "[full]") {
  const Outside folder;
  folder.file("own/register.cpp", "namespace yard {}\n");
  const Done done = run_program(folder, {"blocks", "--blocks", "own"});
  CHECK(done.code == 2);
  CHECK(done.err.find("void register_blocks(stepwire::Registry&)") != std::string::npos);
}

TEST_CASE("a replay without the blocks of a run is told their folder", "[full]") {
  const Outside folder;
  REQUIRE(run_program(folder, {"run", "wave.yaml", "--blocks", "own", "--out", "out"}).code == 0);
  const Done without = run_program(folder, {"verify", "out"});
  CHECK(without.code == 2);
  CHECK(without.err.find("there is no block 'Triple'") != std::string::npos);
  CHECK(without.err.find("the run had the blocks of this folder; give --blocks " + folder.path("own")) !=
        std::string::npos);
}

TEST_CASE("blocks whose registration throws are refused with their folder, as data where that is printed",
          "[full]") {
  const Outside folder;
  folder.file(
      "own/register.cpp",
      "#include <stdexcept>\n#include <stepwire/registry.hpp>\nvoid register_blocks(stepwire::Registry&) { "
      "throw std::runtime_error(\"no licence\"); }\n");
  const Done done = run_program(folder, {"check", "wave.yaml", "--blocks", "own", "--json"});
  CHECK(done.code == 2);
  CHECK(done.err.find(folder.path("own") + ": register_blocks() of these blocks throws: no licence") !=
        std::string::npos);
  CHECK(done.out.find("\"call\": \"--blocks own\"") != std::string::npos);
  CHECK(done.out.find("no licence") != std::string::npos);
}

TEST_CASE("a block from outside that sets the floating-point state changes no number of other blocks",
          "[full]") {
  const Outside folder;
  folder.file("wave.yaml",
              diagram.substr(0, diagram.find("record:")) +
                  "  third: {block: Gain, u: wave, gain: 0.1}\n  lag: {block: Lag, u: third, tau: 0.3 s}\n"
                  "  tiny: {block: Gain, u: wave, gain: 1e-310}\nrecord: [more, third, lag, tiny]\n");
  const auto signals = [&](const std::string& engine) {
    const Done done = run_program(
        folder, {"run", "wave.yaml", "--blocks", "own", "--engine", engine, "--out", "out", "--quiet"});
    INFO(done.err);
    CHECK(done.code == 0);
    return content_of(folder.path("out/signals.csv"));
  };
  const auto write_law = [&](const std::string& deed) {  // the sum is exact in every mode
    folder.file("own/family/law.hpp",
                "#pragma once\n#include <cfenv>\n#include <xmmintrin.h>\ninline double tripled(double u) { " +
                    deed + " return u + u; }\n");
  };
  write_law("");
  const std::string right = signals("interpreted");
  for (const std::string deed : {"std::fesetround(FE_UPWARD);", "_mm_setcsr(_mm_getcsr() | 0x8040u);"})
    for (const std::string engine : {"interpreted", "compiled"}) {
      write_law(deed);
      INFO(deed << " " << engine);
      CHECK(signals(engine) == right);
    }
}
