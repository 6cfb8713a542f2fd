#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engine/model/diagram/load.hpp"

namespace stepwire::python {

/// Cache of a model's documents as they were at the first read. So a reload with other values uses the same
/// diagram even if the files have changed. Thread-safe.
class KeptDocuments {
 public:
  std::shared_ptr<const yaml::Document> read(const std::string& path, const yaml::DocumentLimits& limits);

 private:
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const yaml::Document>> documents_;
};

/// Returns a reader of cached documents. In `file`, the given sections replace those of the same name.
diagram::DocumentReader reader_of(std::shared_ptr<KeptDocuments> documents, std::string file,
                                  std::vector<yaml::Entry> sections);

}  // namespace stepwire::python
