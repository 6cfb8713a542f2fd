#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/model/diagram/load.hpp"
#include "engine/model/diagram/report.hpp"

namespace stepwire::diagram {

/// The `--set` of a call, read as YAML values; each must be used by something.
class Settings {
 public:
  Settings(const std::vector<Setting>& settings, Report& report);

  struct Entry {
    yaml::Document document;
    Origin origin;  ///< its own scope, so that messages name the setting
    bool used = false;
  };
  /// The setting for a full name ("rig.mass"), marked as used; or nullptr.
  Entry* take(const std::string& full_name);
  /// Notes a name that could have been set, for suggestions; cheap where nothing is set.
  void offer(const std::string& full_name);
  /// Names of blocks and parts under `prefix` that settings ask for: "tau" for prefix "lag." of
  /// "lag.tau".
  std::vector<std::string> keys_of(const std::string& prefix) const;
  void report_unused(Report& report) const;

 private:
  std::map<std::string, Entry> entries_;
  std::vector<std::string> offered_;
};

}  // namespace stepwire::diagram
