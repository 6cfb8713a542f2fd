// Generated diagrams as libraries of another project, in C++ and in C.
#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>

#include "engine/base/subprocess/process.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/model/diagram/load.hpp"
#include "engine/simulate/codegen/compiler.hpp"
#include "engine/simulate/codegen/program_files.hpp"
#include "engine/simulate/run/executor.hpp"
#include "tests/engine/base/table/scratch.hpp"
#include "tests/engine/simulate/codegen/consumer_project.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::codegen {

namespace {

void write_program(const Scratch& folder, const plan::Plan& plan, const std::string& name) {
  for (const auto& [path, text] : program_files(plan, tuning_of(plan), {name, "a test", true})) {
    const std::string file = folder.path(name + "/" + path);
    std::filesystem::create_directories(std::filesystem::path(file).parent_path());
    io::write_file(file, text);
  }
}

plan::Plan plan_file(const Scratch& folder, const std::string& name) {
  return plan::make_plan(diagram::Loader(library()).load(folder.path(name)));
}

/// Appends the bytes of the struct `recorded` of a generated program.
void append_recorded(const run::Executor& run, std::string& bytes) {
  for (const diagram::RecordRequest& request : run.plan().diagram.records)
    for (const diagram::RecordedSignal& signal : request.signals) {
      const plan::SignalSlot slot = run.plan().slot(signal.signal);
      bytes.append(reinterpret_cast<const char*>(run.values() + slot.offset),
                   static_cast<std::size_t>(slot.size) * sizeof(double));
    }
}

void set(run::Executor& run, const std::string& name, const std::string& value) {
  REQUIRE(run.set(name, value) == run::Executor::Setting::done);
}

std::string of_rig(const plan::Plan& plan) {
  run::Executor run(plan);
  run.reset();
  run::Workspace kept;
  std::string bytes;
  const auto step = [&] {
    const double lift = 0.01 * static_cast<double>(run.tick());
    run.write_input(0, &lift);
    run.evaluate();
    append_recorded(run, bytes);
    run.advance();
  };
  for (int tick = 0; tick < 100; ++tick) {
    if (tick == 10) set(run, "tau", "0.7 s");
    if (tick == 20) set(run, "half", "0.05 s");
    if (tick == 30) set(run, "tau", "0.15 s");
    if (tick == 40) {
      set(run, "mass", "3 kg");
      set(run, "amp", "[1 N, -2.5 N]");
      set(run, "gains", "[[1, 7], [3, 4]]");
      set(run, "bias", "1 N");
      set(run, "k", "2.5");
    }
    if (tick == 50) set(run, "cart.mass", "5 kg");
    if (tick == 55) set(run, "mass", "4 kg");
    if (tick == 60) kept = run.workspace();
    step();
  }
  run.restore(kept);
  for (int tick = 60; tick < 100; ++tick) step();
  return bytes;
}

std::string of_rack(const plan::Plan& plan) {
  run::Executor run(plan);
  run.reset();
  run::Workspace kept;
  std::string bytes;
  const auto step = [&] {
    const double force = 0.5 * static_cast<double>(run.tick());
    run.write_input(0, &force);
    run.evaluate();
    append_recorded(run, bytes);
    run.advance();
  };
  for (int tick = 0; tick < 50; ++tick) {
    if (tick == 20) kept = run.workspace();
    if (tick == 30) set(run, "tau", "0.02 s");
    step();
  }
  run.restore(kept);
  for (int tick = 20; tick < 50; ++tick) step();
  return bytes;
}

/// First double that differs, with how many there are.
std::string difference(const std::string& a, const std::string& b) {
  if (a.size() != b.size()) return std::to_string(a.size()) + " and " + std::to_string(b.size()) + " bytes";
  for (std::size_t i = 0; i < a.size(); i += sizeof(double))
    if (std::memcmp(a.data() + i, b.data() + i, sizeof(double)) != 0)
      return "number " + std::to_string(i / sizeof(double)) + " of " +
             std::to_string(a.size() / sizeof(double));
  return "";
}

}  // namespace

TEST_CASE(
    "two generated diagrams in one project of C and C++ give the interpreter's bits, whatever parameters and "
    "states are written meanwhile",
    "[full]") {
  if (!Compiler().found()) {
    WARN("there is no C++ compiler here; nothing was compared");
    return;
  }
  const Scratch folder;
  folder.file("part.yaml", part_yaml);
  folder.file("rig.yaml", rig_yaml);
  folder.file("rack.yaml", rack_yaml);
  const plan::Plan rig = plan_file(folder, "rig.yaml"), rack = plan_file(folder, "rack.yaml");
  write_program(folder, rig, "rig");
  write_program(folder, rack, "rack");
  folder.file("consumer.cpp", cpp_consumer);
  folder.file("consumer.c", c_consumer);
  folder.file("CMakeLists.txt", project);
  const std::string build = folder.path("build");
  REQUIRE(subprocess::run_process({.command = {"cmake", "-S", folder.path(""), "-B", build, "-G", "Ninja"}})
              .succeeded());
  const subprocess::ProcessResult built = subprocess::run_process(
      {.command = {"cmake", "--build", build}, .limit = subprocess::compiler_limit()});
  INFO(built.output << built.errors);
  REQUIRE(built.succeeded());
  CHECK_FALSE(std::filesystem::exists(build + "/rig/bin/rig_diagram"));  // built only on request
  const subprocess::ProcessResult cpp = subprocess::run_process({.command = {build + "/cpp"}});
  INFO(cpp.errors);
  CHECK(cpp.status == 0);
  CHECK(difference(cpp.output, of_rig(rig)) == "");
  const subprocess::ProcessResult c = subprocess::run_process({.command = {build + "/c"}});
  CHECK(c.status == 0);
  CHECK(difference(c.output, of_rack(rack)) == "");
}

TEST_CASE("a generated program shows which parameters cannot change, and why") {
  const Scratch folder;
  folder.file("part.yaml", part_yaml);
  folder.file("rig.yaml", rig_yaml);
  const plan::Plan plan = plan_file(folder, "rig.yaml");
  const Tuning tuning = tuning_of(plan);
  REQUIRE(tuning.fixed.size() == 1);
  CHECK(tuning.fixed[0].name == "wait");
  CHECK(tuning.fixed[0].reason ==
        "'periods' of late follows from late.delay, and is computed before a run only");
  const std::string header = program_files(plan, tuning, {"rig", "a test", false}).at("rig.hpp");
  CHECK_THAT(header,
             Catch::Contains("//   wait: 'periods' of late follows from late.delay") &&
                 Catch::Contains("double tau_{0.3};  ///< of the lag [s]; above 0 s; at most 3 s\n") &&
                 Catch::Contains("double amp_[2]{1.0, 2.0};") &&
                 Catch::Contains("double cart_mass_{2.0};  ///< moved [kg]; above 0 kg; '$mass' until") &&
                 Catch::Contains("double cart_cart_position_{};  ///< cart.cart.position, position [m]"));
  CHECK(header.find("double lift_{};") < header.find("double force_[2]{};"));
}

TEST_CASE("what is in a formula of matrices is fixed, and a gain that only changes its sign is not") {
  const plan::Plan plan = plan_text(R"yaml(solver: rk4
parameters:
  m: 2
  A: [[0, 1], [-4, -1/m]]
  K: = place(A, [0, 1/m], [-1, -2])
  two: = 2*m
blocks:
  s: {block: StateSpace, A: $A, B: "[0, 1/m]", C: eye(2), u: f, initial: [1, 0]}
  f: {block: MatrixGain, gain: -K, u: s}
  g: {block: Gain, gain: $two, u: f}
)yaml");
  const Tuning tuning = tuning_of(plan);
  REQUIRE(tuning.fixed.size() == 2);
  for (const auto& fixed : tuning.fixed) {
    CHECK((fixed.name == "m" || fixed.name == "A"));
    CHECK(fixed.reason ==
          "'= place(A, [0, 1/m], [-1, -2])' is a formula of matrices, which is computed before a run only");
  }
  CHECK_THAT(program_files(plan, tuning, {"rig", "a test", false}).at("rig.cpp"),
             Catch::Contains("{(-p.K_[0][0]), (-p.K_[0][1])}"));
}

TEST_CASE("with no parameters to change every number stands in the code") {
  const plan::Plan plan = plan_text(
      "parameters: {k: 0.5}\nblocks:\n  wave: {block: Sine}\n  half: {block: Gain, gain: $k, u: wave}\n");
  const auto text = [&](const Tuning& tuning) {
    return program_files(plan, tuning, {"rig", "a test", false}).at("rig.cpp");
  };
  CHECK_THAT(text({}), Catch::Contains("b.gain = 0.5;") && !Catch::Contains("follow_parameters"));
  CHECK_THAT(text(tuning_of(plan)), Catch::Contains("b.gain = numbers[0];"));
}

}  // namespace stepwire::codegen
