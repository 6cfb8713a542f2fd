#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "blocks/register.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"
#include "engine/simulate/codegen/compiler.hpp"
#include "engine/simulate/codegen/program_files.hpp"
#include "tests/diagrams/diagram_files.hpp"

using namespace stepwire;

namespace {

/// A diagram under diagrams/examples, and the hash of all numbers of its first ticks.
struct Kept {
  std::string file, hash;
};

std::vector<Kept> kept_bits() {
  std::ifstream list(STEPWIRE_SOURCE_DIR "/tests/diagrams/kept-bits.txt");
  std::vector<Kept> all;
  for (Kept one; list >> one.file >> one.hash;) all.push_back(one);
  REQUIRE(all.size() == 20);
  return all;
}

plan::Plan plan_of(const Kept& kept) {
  static const Registry registry = blocks();
  diagram::Loader loader(registry);
  return run::make_job(loader, STEPWIRE_SOURCE_DIR "/diagrams/examples/" + kept.file).plan;
}

std::string hash_of(const plan::Plan& plan) {
  run::Executor run(plan);
  return fmt::format("{:016x}", fingerprint(run, std::min<std::int64_t>(plan.steps, 2000)));
}

constexpr const char* kept_by_all = "twenty diagrams have the bits that are kept for every x86-64 processor";

bool runs(const std::vector<std::string>& command) {
  return subprocess::run_process({.command = command}).succeeded();
}

/// Compiles a generated program, runs it, and returns its recording; the compiler's messages on failure.
std::string recording(std::vector<std::string> compiler, const std::vector<std::string>& runner,
                      const std::string& sources) {
  const subprocess::ScratchFolder folder;
  const std::string program = folder.path() + "/program";
  for (const std::string& flag : codegen::Compiler::flags()) compiler.push_back(flag);
  compiler.insert(compiler.end(), {"-w", "-DSTEPWIRE_SLEEF", "-static-libstdc++", "-static-libgcc", "-I",
                                   sources, "-I", sources + "/stepwire", sources + "/kept.cpp",
                                   sources + "/kept-main.cpp", "-o", program, "-lsleef"});
  const auto made = subprocess::run_process({.command = compiler, .limit = subprocess::compiler_limit()});
  if (!made.succeeded()) return made.errors;
  std::vector<std::string> command = runner;
  command.insert(command.end(), {program, folder.path()});
  const auto ran = subprocess::run_process({.command = command, .limit = std::chrono::minutes(10)});
  return ran.succeeded() ? io::read_file(folder.path() + "/signals.csv") : ran.errors;
}

}  // namespace

// A change of the kept bits is a line of CHANGELOG.md under "Changed results".
TEST_CASE(kept_by_all, "[full]") {
  for (const Kept& one : kept_bits()) {
    INFO(one.file);
    CHECK(hash_of(plan_of(one)) == one.hash);
  }
}

TEST_CASE("the kept bits are those of a processor without AVX and FMA, too", "[full]") {
  // The C library takes other variants of its functions there.
  const subprocess::ProcessResult result = subprocess::run_process(
      {.command = {std::filesystem::read_symlink("/proc/self/exe").string(), kept_by_all},
       .variables = {"GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-FMA4,-AVX512F"},
       .limit = std::chrono::minutes(5)});
  INFO(result.output);
  CHECK(result.succeeded());
}

TEST_CASE("generated programs of the twenty diagrams have the same bits on an emulated ARM64", "[long]") {
  const std::string cross = "aarch64-linux-gnu-g++", emulator = "qemu-aarch64";
  if (!runs({cross, "--version"}) || !runs({emulator, "--version"}) ||
      !std::filesystem::exists("/usr/lib/aarch64-linux-gnu/libsleef.so")) {
    WARN("g++-aarch64-linux-gnu, qemu-user or libsleef-dev:arm64 is not installed; nothing was compared");
    return;
  }
  int compared = 0;
  for (const Kept& one : kept_bits()) {
    INFO(one.file);
    const plan::Plan plan = plan_of(one);
    const subprocess::ScratchFolder folder;
    const auto files = codegen::program_files(plan, codegen::tuning_of(plan), {"kept", "a test"});
    if (codegen::needs_eigen(files)) continue;  // Eigen adds in the order of the processor's vectors
    for (const auto& [path, text] : files) {
      std::filesystem::create_directories(std::filesystem::path(folder.path() + "/" + path).parent_path());
      io::write_file(folder.path() + "/" + path, text);
    }
    const std::string here = recording({"g++"}, {}, folder.path());
    CHECK(here.starts_with("time"));
    CHECK(recording({cross}, {emulator}, folder.path()) == here);
    ++compared;
  }
  CHECK(compared > 14);
}
