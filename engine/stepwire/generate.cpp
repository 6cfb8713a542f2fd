#include "engine/stepwire/generate.hpp"

#include <filesystem>

#include "engine/base/io/file.hpp"
#include "engine/simulate/codegen/program_files.hpp"
#include "engine/stepwire/content.hpp"

namespace stepwire {

const char* version() {
  return STEPWIRE_VERSION;
}

std::map<std::string, std::string> generated_files(const Model& model, const GenerateOptions& options) {
  const plan::Plan& plan = model.content().job->plan;
  const std::string name =
      options.name.empty() ? std::filesystem::path(model.file()).stem().string() : options.name;
  return codegen::program_files(plan,
                                options.constant_parameters ? codegen::Tuning{} : codegen::tuning_of(plan),
                                {name, std::string("stepwire ") + version(), options.c_interface});
}

void generate(const Model& model, const std::string& folder, const GenerateOptions& options) {
  for (const auto& [path, text] : generated_files(model, options)) {
    const std::filesystem::path target = std::filesystem::path(folder) / path;
    io::require_folder(target.parent_path().string());
    io::write_file(target.string(), text);
  }
}

}  // namespace stepwire
