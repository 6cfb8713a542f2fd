// Tries laws on random diagrams; tests/README.md explains them.
#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "blocks/register.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"
#include "tests/random/generator.hpp"
#include "tests/random/options.hpp"
#include "tests/random/shrink.hpp"
#include "tests/support/units/units.hpp"

namespace {

using namespace stepwire;
using random::Options;

/// Writes the data files of diagrams into a folder.
void write_data(const std::string& folder) {
  std::string record = "time [s],x [mm]\n";
  for (int row = 0; row < 400; ++row)
    record += fmt::format("{},{}\n", row * 1e-3, (row * 7 % 31) * 0.1 - 1.5);
  io::write_file(folder + "/record.csv", record);
  testing::write_zip(folder + "/unit.fmu", testing::unit_of_3("dahlquist"));
}

void write_sketch(const std::string& folder, const random::Sketch& sketch, const std::string& head) {
  std::filesystem::create_directories(folder);
  write_data(folder);
  io::write_file(folder + "/random.yaml", head + random::text_of(sketch));
  for (const auto& [file, part] : sketch.parts) io::write_file(folder + "/" + file, random::text_of(part));
}

void report(random::Trials& trials, const random::Failure& failure, const Options& options) {
  fmt::print("seed {}, {}: {}\n", failure.seed, failure.law->name, failure.text);
  std::fflush(stdout);
  const random::Failure least = options.shrinks ? random::shrunk(trials, failure) : failure;
  const std::string folder =
      fmt::format("{}/seed-{}-{}", options.out, failure.seed, failure.law - random::laws().data());
  write_sketch(folder, least.sketch,
               fmt::format("# seed {}, {}: {}\n# tests/random/run --seed {} --count 1\n", failure.seed,
                           failure.law->name, least.text.substr(0, least.text.find('\n')), failure.seed));
  fmt::print("  made smaller: {}/random.yaml: {}\n", folder, least.text);
  std::fflush(stdout);
}

int try_all(const Registry& registry, const Options& options) {
  const subprocess::ScratchFolder folder;
  write_data(folder.path());
  random::Trials trials(registry, folder.path());
  std::uint64_t seed = options.seed;
  do {
    const std::size_t known = trials.totals().failures.size();
    trials.run(seed, options.count, options.with_code);
    for (std::size_t i = known; i < trials.totals().failures.size(); ++i)
      report(trials, trials.totals().failures[i], options);
    fmt::print("{}", random::totals_text(trials.totals()));
    std::fflush(stdout);
    seed += options.count;
  } while (options.forever && trials.totals().failures.empty());
  const std::string weakness = random::weakness_of(trials.totals(), registry);
  if (!weakness.empty()) fmt::print("the trial proves too little: {}\n", weakness);
  return trials.totals().failures.empty() && weakness.empty() ? 0 : 1;
}

int show(const Registry& registry, const Options& options) {
  write_sketch(options.out, random::random_sketch(registry, options.seed), "");
  fmt::print("{}", io::read_file(options.out + "/random.yaml"));
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  const Options options = random::read_options(argc - 1, argv + 1);
  if (options.help) {
    fmt::print("{}", random::help_text());
    return 0;
  }
  const Registry registry = blocks();
  return options.show ? show(registry, options) : try_all(registry, options);
} catch (const std::invalid_argument& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 2;
}
