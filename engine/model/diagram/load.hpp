#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/yaml/document.hpp"
#include "engine/model/block/registry.hpp"
#include "engine/model/diagram/diagram.hpp"

namespace stepwire::diagram {

/// One `--set name=value`, or a value of a sweep; the name reaches into parts ("rig.mass") and blocks
/// ("lag.tau").
struct Setting {
  std::string name;
  std::string value;
  std::string written = "--set " + name + "=" + value;  ///< how messages call it: the call, or a file
  yaml::Mark mark{};                                    ///< where in that file
};

/// Turns diagram files into checked diagrams. Files are read once, however often they are used.
class Loader {
 public:
  /// The registry must outlive the diagrams, too, whose blocks know their types by it.
  explicit Loader(const Registry& registry, yaml::DocumentLimits limits = {})
      : registry_(registry), limits_(limits) {}
  explicit Loader(Registry&&, yaml::DocumentLimits = {}) = delete;

  /// Reads and checks a file. Throws Error with everything that is wrong; EnvironmentError where a block
  /// needs the data folder (STEPWIRE_DATA) and it is not there.
  Diagram load(const std::string& path, const std::vector<Setting>& settings = {});
  /// The same for one run of the file's sweep: without what only the file as a whole needs (sweep, figures,
  /// claims).
  Diagram load_point(const std::string& path, const std::vector<Setting>& settings);
  /// The same for text; parts and data files are looked for beside `file`.
  Diagram load_text(std::string_view text, const std::string& file,
                    const std::vector<Setting>& settings = {});

  const Registry& registry() const { return registry_; }
  const yaml::Document& document(const std::string& path);
  /// Takes a document for the file that it names; no such file needs to be there.
  void add(yaml::Document document);

 private:
  const Registry& registry_;
  yaml::DocumentLimits limits_;
  std::map<std::string, std::unique_ptr<yaml::Document>> documents_;
};

}  // namespace stepwire::diagram
