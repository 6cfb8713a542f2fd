#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/model/diagram/load.hpp"
#include "engine/model/diagram/report.hpp"
#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

/// Values of `--set` in a call, parsed as YAML; each one must be used.
class Settings {
 public:
  Settings(const std::vector<Setting>& settings, Report& report);

  struct Entry {
    yaml::Document document;
    Origin origin;  ///< its own scope, so that messages name the setting
    bool used = false;
  };
  /// Returns the setting of a full name ("rig.mass") and marks it as used; nullptr if there is none.
  Entry* take(const std::string& full_name);
  /// True if some setting ends in this key of a block: "spring.gain" in "gain".
  bool set_some(const std::string& key) const;
  /// Records a settable name for suggestions; cheap without settings.
  void offer(const std::string& full_name);
  /// Returns the keys below `prefix` that settings name: "tau" for prefix "lag." of "lag.tau".
  std::vector<std::string> keys_of(const std::string& prefix) const;
  void report_unused(Report& report) const;

 private:
  std::map<std::string, Entry> entries_;
  std::vector<std::string> offered_;
};

/// Values of a part's parameters given by the using file, and the scope for reading them.
struct Overrides {
  const Scope* from = nullptr;
  std::map<std::string, const yaml::Node*> values;
};

/// Evaluates `parameters:` of a scope in the order of their dependences, with the replacements by the using
/// file and `--set`. Defines them in the scope and lists them in the Diagram.
void define_parameters(Scope& scope, const Overrides& overrides, Settings& settings, Report& report);

}  // namespace stepwire::diagram
