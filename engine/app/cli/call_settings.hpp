#pragma once

#include <string>
#include <vector>

#include "engine/model/diagram/load.hpp"

namespace CLI {
class App;
}

namespace stepwire {

/// The words of --set and --set-from of a call.
struct SettingWords {
  std::vector<std::string> set;
  std::vector<std::string> files;
};

void add_setting_options(CLI::App& verb, SettingWords& words);

/// All settings, those of files first, so that the call's own win. Throws CLI::ValidationError for what is
/// not "name=value", Error for a file that is no flat list of values.
std::vector<Setting> settings_of(const SettingWords& words);

}  // namespace stepwire
