#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "blocks/register.hpp"
#include "engine/base/subprocess/process.hpp"
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
  return all;
}

std::string hash_of(const std::string& file) {
  static const Registry registry = blocks();
  diagram::Loader loader(registry);
  const run::Job job = run::make_job(loader, STEPWIRE_SOURCE_DIR "/diagrams/examples/" + file);
  run::Executor run(job.plan);
  return fmt::format("{:016x}", fingerprint(run, std::min<std::int64_t>(job.plan.steps, 2000)));
}

constexpr const char* name = "twenty diagrams have the bits that are kept for every x86-64 processor";

}  // namespace

// The kept bits are those of x86-64. A change of them is a line of CHANGELOG.md under "Changed results".
TEST_CASE(name, "[full]") {
  const std::vector<Kept> all = kept_bits();
  REQUIRE(all.size() == 20);
  for (const Kept& one : all) {
    INFO(one.file);
    CHECK(hash_of(one.file) == one.hash);
  }
}

TEST_CASE("the kept bits are those of a processor without AVX and FMA, too", "[full]") {
  // The C library takes other variants of its functions there.
  const subprocess::ProcessResult result = subprocess::run_process(
      {.command = {std::filesystem::read_symlink("/proc/self/exe").string(), name},
       .variables =
           {"GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-FMA4,-AVX512F,-AVX_Usable,-AVX2_Usable,"
            "-FMA_Usable,-FMA4_Usable,-AVX512F_Usable"},
       .limit = std::chrono::minutes(5)});
  INFO(result.output);
  CHECK(result.succeeded());
}
