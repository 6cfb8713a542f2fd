#include "engine/app/cli/load_words.hpp"

#include <CLI/CLI.hpp>

namespace stepwire::cli {

namespace {

constexpr yaml::DocumentLimits large_limits{
    .bytes = std::size_t{512} << 20, .depth = 64, .nodes = 64'000'000};

diagram::Setting parse_setting(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos || equals + 1 == text.size())
    throw yaml::Error(
        yaml::Fault{{"--set " + text, {}}, "", "is no setting; write name=value, as --set rig.mass=2kg", {}});
  return {text.substr(0, equals), text.substr(equals + 1)};
}

void append_file(const std::string& path, std::vector<diagram::Setting>& settings) {
  const yaml::Document document = yaml::read_document(path);
  const char* const form = "a file of settings has lines such as 'rig.mass: 2 kg'";
  if (!document.root.is_map()) throw yaml::Error(yaml::Fault{{path, document.root.mark}, "", form, {}});
  for (const yaml::Entry& entry : document.root.entries) {
    if (!entry.value.is_scalar())
      throw yaml::Error(yaml::Fault{{path, entry.value.mark}, entry.key, form, {}});
    settings.push_back({entry.key, entry.value.text, path, entry.value.mark});
  }
}

}  // namespace

void add_load_options(CLI::App& verb, LoadWords& words) {
  verb.add_option("--set", words.set,
                  "a parameter in place of the file's: name=value; reaches into parts (rig.mass=2kg)")
      ->allow_extra_args(false);
  verb.add_option("--set-from", words.set_from,
                  "a file with such values, as 'name: value'; fit and tune write one")
      ->allow_extra_args(false);
  verb.add_flag("--large", words.large, "read files above 8 MB, up to 512 MB");
}

session::LoadOptions load_options(const LoadWords& words) {
  session::LoadOptions options;
  for (const std::string& path : words.set_from) append_file(path, options.settings);
  for (const std::string& text : words.set) options.settings.push_back(parse_setting(text));
  if (!words.stop.empty()) options.stop = words.stop;
  if (words.large) options.limits = large_limits;
  return options;
}

}  // namespace stepwire::cli
