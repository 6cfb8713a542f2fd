// Generated programs are sources of other people's projects: they compile without warnings, and on a target
// without a heap.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "engine/base/io/file.hpp"
#include "engine/base/io/resources.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/model/diagram/load.hpp"
#include "engine/simulate/codegen/program_files.hpp"
#include "tests/engine/base/table/scratch.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::codegen {

namespace {

using Words = std::vector<std::string>;

const Words warnings{"-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Wsign-conversion"};

/// Lists of parameters that are longer than a list holds in itself elsewhere.
const char* const long_lists = R"(solver: rk4
parameters:
  tau: {value: [1 s, 2 s, 3 s, 4 s, 5 s, 6 s, 7 s, 8 s]}
  u: {value: [1, 2, 3, 4, 5, 6, 7, 8]}
blocks:
  lag: {block: Lag, u: {value: $u}, tau: $tau}
  wave: {block: Sine, amplitude: $u, frequency: 1 Hz}
  mean: {block: MovingAverage, u: wave, window: 2 s, every: 1 s}
record: [lag, wave, mean]
)";

plan::Plan plan_of_file(const std::string& name) {
  return plan::make_plan(
      diagram::Loader(library()).load(std::string(STEPWIRE_SOURCE_DIR) + "/diagrams/" + name + ".yaml"));
}

/// The program `g` of a plan, with its interface of C.
struct Program {
  explicit Program(const plan::Plan& plan)
      : files(program_files(plan, tuning_of(plan), {"g", "a test", true})) {
    for (const auto& [path, text] : files) {
      const std::string file = folder.path(path);
      std::filesystem::create_directories(std::filesystem::path(file).parent_path());
      io::write_file(file, text);
    }
  }

  /// Calls a program in the folder and returns all that it prints; fails where it fails.
  std::string output(const Words& command) const {
    const auto done = subprocess::run_process({.command = command});
    INFO(fmt::format("{}\n{}{}", fmt::join(command, " "), done.output, done.errors));
    CHECK(done.status == 0);
    return done.output + done.errors;
  }
  std::string compiled(const std::string& compiler, const std::string& source, const Words& more) const {
    Words command{compiler,   "-std=c++20",         "-I" + folder.path(""), "-I" + folder.path("stepwire"),
                  "-isystem", io::resource("eigen")};
    command.insert(command.end(), more.begin(), more.end());
    command.push_back(folder.path(source));
    return output(command);
  }

  Scratch folder;
  std::map<std::string, std::string> files;
};

void check_no_warning(const Program& program) {
  for (const std::string compiler : {"g++", "clang++"}) {
    if (subprocess::find_program(compiler).empty()) {
      WARN(compiler << " is not here; its warnings are not looked for");
      continue;
    }
    Words flags = warnings;
    flags.insert(flags.end(), {"-O1", "-fsyntax-only"});
    for (const std::string source : {"g.cpp", "g-c.cpp", "g-main.cpp"})
      CHECK(program.compiled(compiler, source, flags) == "");
  }
}

void check_no_heap(const Program& program) {
  const std::string object = program.folder.path("g.o");
  program.compiled("g++", "g.cpp", {"-O1", "-DNDEBUG", "-c", "-o", object});
  const std::string symbols = program.output({"nm", "--demangle", "--undefined-only", object});
  for (const std::string heap :
       {"operator new", "operator delete", "malloc", "free", "realloc", "__cxa_throw"}) {
    INFO(symbols);
    CHECK(symbols.find(heap) == symbols.npos);
  }
}

}  // namespace

TEST_CASE("generated programs compile without a warning, by g++ and clang++", "[full]") {
  for (const std::string name :
       {"examples/03-parameters", "examples/23-state-machine", "examples/109-relay-oscillator",
        "examples/156-both-sides", "thesis/fig32-linear-motor"}) {
    INFO(name);
    check_no_warning(Program(plan_of_file(name)));
  }
}

TEST_CASE("generated programs need no heap: the force controller, and lists of any length", "[full]") {
  const Program controller(plan_of_file("thesis/fig14-controller-1d"));
  check_no_warning(controller);
  check_no_heap(controller);
  const Program lists(plan_text(long_lists));
  check_no_warning(lists);
  check_no_heap(lists);
}

TEST_CASE("a generated program that needs Eigen names it, and another one does not") {
  const Program stiff(plan_of_file("examples/21-stiff-plant"));
  CHECK(needs_eigen(stiff.files));
  CHECK_THAT(stiff.files.at("CMakeLists.txt"),
             Catch::Contains("needs the headers of Eigen 3") && Catch::Contains("find_package(Eigen3 QUIET"));
  CHECK_THAT(stiff.files.at("g.cpp"), Catch::Contains("#if !__has_include(<Eigen/Core>)"));
  const Program plain(plan_of_file("examples/03-parameters"));
  CHECK_FALSE(needs_eigen(plain.files));
  CHECK_THAT(plain.files.at("CMakeLists.txt"), !Catch::Contains("Eigen"));
}

}  // namespace stepwire::codegen
