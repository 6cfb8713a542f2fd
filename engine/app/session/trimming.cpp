// Operating points of diagram files.
#include <fmt/format.h>

#include "engine/app/session/linearizing.hpp"
#include "engine/app/session/search_parts.hpp"
#include "engine/base/io/file.hpp"

namespace stepwire::session {

linear::TrimResult trim_file(const Registry& registry, const std::string& file, const LoadOptions& options) {
  const LoadedModel model = load_model(registry, file, options);
  if (!model.trim)
    throw yaml::Error(yaml::Fault{
        {file, {}}, "", "has no section 'trim'; it says which states, inputs and outputs are given", {}});
  diagram::Loader loader(registry, options.limits, options.reader);
  linear::TrimResult result = linear::trim(loader.load(file, options.settings), *model.trim);
  result.file = file;
  return result;
}

std::vector<diagram::Setting> settings_of(const linear::TrimResult& result) {
  std::vector<diagram::Setting> settings;
  for (const auto* values : {&result.states, &result.inputs})
    for (const linear::TrimmedValue& value : *values) {
      if (value.setting.empty()) continue;
      std::string text = fmt::format("{}", value.value);
      if (!value.channel.unit.empty()) text += " " + value.channel.unit;
      settings.push_back({value.setting, std::move(text), "found by trim: " + value.setting});
    }
  return settings;
}

void write_trim(const std::string& folder, const linear::TrimResult& result) {
  io::write_file(folder + "/trim.json", result::json_of(result).text() + "\n");
  io::write_file(folder + "/parameters.yaml",
                 parameters_text("Found by a trim of", result.file, settings_of(result)));
}

}  // namespace stepwire::session
