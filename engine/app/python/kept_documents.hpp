#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engine/model/diagram/load.hpp"

namespace stepwire::python {

/// The documents of a model as they were when each was read first: what is loaded again with other values is
/// the same diagram, whatever has become of the files. From any thread.
class KeptDocuments {
 public:
  std::shared_ptr<const yaml::Document> read(const std::string& path, const yaml::DocumentLimits& limits);

 private:
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const yaml::Document>> documents_;
};

/// Reads kept documents; `sections` stand in the place of those of the same name in `file`.
diagram::DocumentReader reader_of(std::shared_ptr<KeptDocuments> documents, std::string file,
                                  std::vector<yaml::Entry> sections);

}  // namespace stepwire::python
