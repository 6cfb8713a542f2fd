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

/// One `--set name=value`, or a value of a sweep; the name reaches into parts ("rig.mass") and blocks
/// ("lag.tau").
struct Setting {
  std::string name;
  std::string value;
  std::string written = "--set " + name + "=" + value;  ///< how messages call it: the call, or a file
  yaml::Mark mark{};                                    ///< where in that file
};

/// Gives the document of a path, from wherever its text is. Throws Error as read_document() does.
using DocumentReader = std::function<std::shared_ptr<const yaml::Document>(
    const std::string& path, const yaml::DocumentLimits& limits)>;

/// What a file is as far as it can be read, and all that is wrong with it.
struct UnfinishedDiagram {
  Diagram diagram;
  std::vector<yaml::Fault> faults;
  PortUnits input_units{};
};

/// Turns diagram files into checked diagrams. Files are read once, however often they are used.
class Loader {
 public:
  /// The registry must outlive the diagrams, too, whose blocks know their types by it.
  /// Without a reader documents are files.
  explicit Loader(const Registry& registry, yaml::DocumentLimits limits = {}, DocumentReader reader = {})
      : registry_(registry), limits_(limits), reader_(std::move(reader)) {}
  explicit Loader(Registry&&, yaml::DocumentLimits = {}, DocumentReader = {}) = delete;

  /// Reads and checks a file. Throws Error with everything that is wrong; EnvironmentError where a block
  /// needs the data folder (STEPWIRE_DATA) and it is not there.
  Diagram load(const std::string& path, const std::vector<Setting>& settings = {});
  /// The same for one run of the file's sweep: without what only the file as a whole needs (sweep, figures,
  /// claims).
  Diagram load_point(const std::string& path, const std::vector<Setting>& settings);
  /// The same for text; parts and data files are looked for beside `file`.
  Diagram load_text(std::string_view text, const std::string& file,
                    const std::vector<Setting>& settings = {});

  /// The same for an editor, which shows what there is of a file with faults. Units are inferred as far as
  /// they follow. Throws Error where the file itself is no YAML.
  UnfinishedDiagram draft(const std::string& path);

  const Registry& registry() const { return registry_; }
  const yaml::Document& document(const std::string& path);
  /// Takes a document for the file that it names; no such file needs to be there.
  void add(yaml::Document document);
  /// The paths of all documents that were read or added, and of those that could not be read.
  std::vector<std::string> paths() const;

 private:
  const Registry& registry_;
  yaml::DocumentLimits limits_;
  DocumentReader reader_;
  std::map<std::string, std::shared_ptr<const yaml::Document>> documents_;
};

}  // namespace stepwire::diagram
