#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "blocks/register.hpp"
#include "engine/app/fmu/unit_export.hpp"
#include "engine/base/archive/archive.hpp"
#include "engine/base/io/file.hpp"
#include "engine/simulate/run/run.hpp"
#include "tests/diagrams/diagram_files.hpp"
#include "tests/diagrams/imported_unit.hpp"
#include "tests/support/units/schema.hpp"

using namespace stepwire;

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t ticks = 200;

/// A unit of a diagram, and what it is compared by.
struct Exported {
  std::string file, refused, invalid;
  bool exchanges = false;
};

/// Flags of a unit's binary. Optimised or not, the bits are the same; compiling is faster, and standard
/// headers are precompiled for it.
std::vector<std::string> unit_flags(const codegen::Compiler& compiler, const std::string& folder) {
  std::vector<std::string> flags{"-O0"};
  CHECK(compiler.precompile(folder, flags) == "");
  if (const std::string headers = folder + "/standard.hpp"; fs::exists(headers))
    flags.insert(flags.end(), {"-include", headers});
  return flags;
}

Exported export_job(const run::Job& job, int version, const codegen::Compiler& compiler,
                    const std::vector<std::string>& flags, const std::string& stem) {
  Exported made;
  try {
    const codegen::Tuning tuning = codegen::tuning_of(job.plan);
    const auto unit =
        fmu::export_unit(job.plan, tuning,
                         {.version = version, .name = "unit", .made_by = "a test", .flags = flags}, compiler);
    made.file = stem + ".fmu";
    made.exchanges = unit.no_exchange.empty();
    io::write_file(made.file, archive::archive_bytes(unit.files));
    io::write_file(stem + ".xml", unit.files.at("modelDescription.xml"));
    made.invalid = testing::schema_fault(stem + ".xml", version);
  } catch (const std::exception& error) {
    made.refused = error.what();
  }
  return made;
}

std::string difference(const run::Job& job, const Exported& made, const char* interface) {
  static const Registry registry = blocks();
  io::write_file(made.file + ".yaml",
                 text_with_unit(job.plan.diagram, made.file, fmt::format("interface: {}", interface), ticks));
  const plan::Plan outer = plan::make_plan(diagram::Loader(registry).load(made.file + ".yaml"));
  return difference_of_unit(job.plan, outer, made.exchanges, ticks);
}

/// Exports each diagram, every second one as a unit of FMI 2, the others of FMI 3, and imports it again.
void compare_units(const std::vector<run::Job>& jobs) {
  const codegen::Compiler compiler;
  if (!compiler.found()) {
    WARN("there is no C++ compiler here; nothing was compared");
    return;
  }
  const fs::path folder = fs::temp_directory_path() / fmt::format("stepwire-exported-{}", ::getpid());
  fs::create_directories(folder);
  const std::vector<std::string> flags = unit_flags(compiler, folder / "headers");
  std::vector<Exported> made(jobs.size());
  in_parallel(jobs.size(), [&](std::size_t i) {
    made[i] = export_job(jobs[i], i % 2 == 0 ? 3 : 2, compiler, flags, (folder / std::to_string(i)).string());
  });
  std::size_t exchanges = 0;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    INFO(jobs[i].plan.diagram.file);
    if (!made[i].refused.empty()) {
      WARN("cannot be exported: " << made[i].refused);
      continue;
    }
    CHECK(made[i].invalid == "");
    CHECK(difference(jobs[i], made[i], "co_simulation") == "");
    if (!made[i].exchanges) continue;
    ++exchanges;
    CHECK(difference(jobs[i], made[i], "model_exchange") == "");
  }
  CHECK(exchanges > 10);
  fs::remove_all(folder);
}

}  // namespace

TEST_CASE("units of diagrams of all blocks are valid, and have the diagram's bits when they are imported") {
  compare_units(jobs_of_all_blocks([](const run::Job&) { return true; }));
}

TEST_CASE("each diagram that can be generated is a valid unit, and has its bits when it is imported",
          "[long]") {
  compare_units(distinct_jobs());
}
