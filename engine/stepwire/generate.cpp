#include "engine/stepwire/generate.hpp"

#include <filesystem>

#include "engine/base/io/file.hpp"
#include "engine/simulate/codegen/program_files.hpp"
#include "engine/stepwire/content.hpp"

namespace stepwire {

const char* version() {
  return STEPWIRE_VERSION;
}

std::map<std::string, std::string> generated_files(const Model& model) {
  return program_files(model.content().job.plan, std::filesystem::path(model.file()).stem().string(),
                       std::string("stepwire ") + version());
}

void generate(const Model& model, const std::string& folder) {
  for (const auto& [path, text] : generated_files(model)) {
    const std::filesystem::path target = std::filesystem::path(folder) / path;
    require_folder(target.parent_path().string());
    write_file(target.string(), text);
  }
}

}  // namespace stepwire
