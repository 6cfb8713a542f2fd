// Operating points of diagram files.
#include <fmt/format.h>

#include "engine/app/session/linearizing.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::session {

using json::Json;

namespace {

Json trimmed_json(const std::vector<linear::TrimmedValue>& values) {
  Json list = Json::list();
  for (const linear::TrimmedValue& value : values)
    list.push(Json::object()
                  .set("name", value.channel.name)
                  .set("value", value.value)
                  .set("unit", value.channel.unit.empty() ? Json() : Json(value.channel.unit))
                  .set("free", value.free)
                  .set("at_bound", value.at_bound)
                  .set("setting", value.setting.empty() ? Json() : Json(value.setting)));
  return list;
}

}  // namespace

linear::TrimResult trim_file(const Registry& registry, const std::string& file, const LoadOptions& options) {
  const LoadedModel model = load_model(registry, file, options);
  if (!model.trim)
    throw yaml::Error(yaml::Fault{
        {file, {}}, "", "has no section 'trim'; it says which states, inputs and outputs are given", {}});
  diagram::Loader loader(registry, options.limits, options.reader);
  return linear::trim(loader.load(file, options.settings), *model.trim);
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

Json trim_json(const std::string& file, const linear::TrimResult& result) {
  Json residuals = Json::list();
  for (const auto& [channel, value] : result.residuals)
    residuals.push(Json::object().set("name", channel.name).set("value", value));
  return Json::object()
      .set("file", file)
      .set("converged", result.converged)
      .set("iterations", result.iterations)
      .set("residual", result.largest)
      .set("states", trimmed_json(result.states))
      .set("inputs", trimmed_json(result.inputs))
      .set("outputs", trimmed_json(result.outputs))
      .set("residuals", std::move(residuals));
}

void write_trim(const std::string& folder, const std::string& file, const linear::TrimResult& result) {
  io::write_file(folder + "/trim.json", trim_json(file, result).text() + "\n");
  std::string text = fmt::format("# Found by a trim of {}; stepwire run FILE --set-from takes this file.\n",
                                 text::visible(file));
  for (const diagram::Setting& setting : settings_of(result))
    text += fmt::format("{}: {}\n", setting.name, setting.value);
  io::write_file(folder + "/parameters.yaml", text);
}

}  // namespace stepwire::session
