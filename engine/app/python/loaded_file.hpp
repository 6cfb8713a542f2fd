#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/python/raised.hpp"
#include "engine/app/session/session.hpp"
#include "engine/model/diagram/load.hpp"
#include "engine/stepwire/model.hpp"

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

/// Block types that a model may use, and the store of exceptions from Python blocks.
struct Kinds {
  Registry registry{};
  std::shared_ptr<Raised> raised = std::make_shared<Raised>();
};

/// Arguments with which a file is loaded.
struct LoadCall {
  std::string file;
  std::vector<diagram::Setting> settings{};
  std::optional<std::string> stop{};
  std::vector<yaml::Entry> sections{};  ///< sections that replace those of the file
};

/// Loaded diagram file, for sessions and for the library. Immutable and thread-safe.
class LoadedFile {
 public:
  /// Throws Error and EnvironmentError.
  LoadedFile(std::shared_ptr<const Kinds> kinds, std::shared_ptr<KeptDocuments> documents, LoadCall call);

  const session::LoadedModel& model() const { return model_; }
  const LoadCall& call() const { return call_; }
  const std::shared_ptr<const Kinds>& kinds() const { return kinds_; }
  const std::shared_ptr<KeptDocuments>& documents() const { return documents_; }
  /// Returns the library's view of the diagram, which keeps `of` alive.
  static Model library_model(const std::shared_ptr<const LoadedFile>& of);

  /// Returns a session for exclusive use until give_back(). A session caches data that its calls can share.
  std::unique_ptr<session::Session> take_session() const;
  void give_back(std::unique_ptr<session::Session> session) const;

 private:
  std::shared_ptr<const Kinds> kinds_;
  std::shared_ptr<KeptDocuments> documents_;
  LoadCall call_;
  session::LoadedModel model_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<session::Session>> idle_;
  mutable std::weak_ptr<const Model::Content> content_;
};

using File = std::shared_ptr<const LoadedFile>;

}  // namespace stepwire::python
