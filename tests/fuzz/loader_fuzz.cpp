#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "blocks/register.hpp"
#include "engine/app/session/loaded_model.hpp"
#include "engine/base/io/environment_error.hpp"

namespace {

using namespace stepwire;
namespace fs = std::filesystem;

// A folder that is not there, so that nothing but the parts below is found beside the text.
const std::string folder = "/nonexistent/stepwire-fuzz/";
constexpr std::size_t max_runs = 8, max_numbers = 1 << 20;

std::vector<yaml::Document> read_parts() {
  std::vector<yaml::Document> parts;
  for (const auto& entry : fs::directory_iterator(STEPWIRE_SOURCE_DIR "/diagrams/parts")) {
    if (entry.path().extension() != ".yaml") continue;
    parts.push_back(yaml::read_document(entry.path().string()));
    parts.back().file = folder + "parts/" + entry.path().filename().string();
  }
  return parts;
}

/// True if the sweep has more runs than this test prepares; they would only take time.
bool is_large(const diagram::Diagram& diagram) {
  return diagram.sweep && diagram.sweep->count() > static_cast<double>(max_runs);
}

void step(const plan::Plan& plan) {
  if (plan.layout.size > max_numbers) return;
  run::Executor simulation(plan);
  for (int tick = 0; tick < 3; ++tick) {
    simulation.evaluate();
    if (!simulation.healthy() || simulation.finished()) break;
    simulation.advance();
  }
  static_cast<void>(simulation.fault());
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  ::unsetenv("STEPWIRE_DATA");
  return 0;
}

// Any text must give a diagram that can be stepped, or an Error; anything else that is thrown ends the
// program, and that is a find.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Registry registry = blocks();
  static const std::vector<yaml::Document> parts = read_parts();
  const std::string file = folder + "fuzz/fuzz.yaml";
  try {
    diagram::Loader loader(registry);
    for (const yaml::Document& part : parts) loader.add(part);
    loader.add(yaml::parse_document({reinterpret_cast<const char*>(data), size}, file));
    if (is_large(loader.load(file))) return 0;
    step(session::load_model(loader, file, {}).job.plan);
  } catch (const yaml::Error&) {
  } catch (const io::EnvironmentError&) {
  }
  return 0;
}
