#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/yaml/document.hpp"
#include "engine/model/block/registry.hpp"
#include "engine/model/diagram/diagram.hpp"

namespace stepwire::diagram {

/// A value set by `--set name=value` or by a sweep. The name may refer to parts ("rig.mass") and blocks
/// ("lag.tau").
struct Setting {
  std::string name;
  std::string value;
  std::string written = "--set " + name + "=" + value;  ///< its text in messages: the call, or a file
  yaml::Mark mark{};                                    ///< in that file
};

/// Function that returns the document of a path from any storage. Throws Error as read_document() does.
using DocumentReader = std::function<std::shared_ptr<const yaml::Document>(
    const std::string& path, const yaml::DocumentLimits& limits)>;

/// An incomplete diagram with all faults of its file.
struct UnfinishedDiagram {
  Diagram diagram;
  std::vector<yaml::Fault> faults;
  PortUnits input_units{};
};

/// Loads diagram files and checks them. Each file is read only once.
class Loader {
 public:
  /// The registry must also outlive the diagrams, whose blocks refer to its types. Without a reader,
  /// documents are files.
  explicit Loader(const Registry& registry, yaml::DocumentLimits limits = {}, DocumentReader reader = {})
      : registry_(registry), limits_(limits), reader_(std::move(reader)) {}
  explicit Loader(Registry&&, yaml::DocumentLimits = {}, DocumentReader = {}) = delete;

  /// Loads and checks a file. Throws Error with all faults. Throws EnvironmentError where a block needs the
  /// data folder (STEPWIRE_DATA) and it is missing.
  Diagram load(const std::string& path, const std::vector<Setting>& settings = {});
  /// Loads a file for one run of its sweep, without the sections of the file as a whole (sweep, figures,
  /// claims).
  Diagram load_point(const std::string& path, const std::vector<Setting>& settings);
  /// Loads a diagram from text; parts and data files are searched beside `file`.
  Diagram load_text(std::string_view text, const std::string& file,
                    const std::vector<Setting>& settings = {});

  /// Loads a file for an editor, which also shows files with faults. Units are inferred as far as possible.
  /// Throws Error for a file that is not YAML.
  UnfinishedDiagram draft(const std::string& path);

  const Registry& registry() const { return registry_; }
  const yaml::Document& document(const std::string& path);
  /// Uses a document in place of the file that it names, which may be missing.
  void add(yaml::Document document);
  /// Returns the paths of all documents that were read or added, and of unreadable ones.
  std::vector<std::string> paths() const;

 private:
  const Registry& registry_;
  yaml::DocumentLimits limits_;
  DocumentReader reader_;
  std::map<std::string, std::shared_ptr<const yaml::Document>> documents_;
};

}  // namespace stepwire::diagram
