#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/app/python/kept_documents.hpp"
#include "engine/app/python/raised.hpp"
#include "engine/app/session/session.hpp"
#include "engine/stepwire/model.hpp"

namespace stepwire::python {

/// The kinds of block that a model may use, and what those of Python's raise.
struct Kinds {
  Registry registry{};
  std::shared_ptr<Raised> raised = std::make_shared<Raised>();
};

/// What a file is loaded with beside its own text.
struct LoadCall {
  std::string file;
  std::vector<diagram::Setting> settings{};
  std::optional<std::string> stop{};
  std::vector<yaml::Entry> sections{};  ///< in the place of those of the file
};

/// A diagram file that is loaded, for sessions and for the library. Never changes; from any thread.
class LoadedFile {
 public:
  /// Throws Error, EnvironmentError.
  LoadedFile(std::shared_ptr<const Kinds> kinds, std::shared_ptr<KeptDocuments> documents, LoadCall call);

  const session::LoadedModel& model() const { return model_; }
  const LoadCall& call() const { return call_; }
  const std::shared_ptr<const Kinds>& kinds() const { return kinds_; }
  const std::shared_ptr<KeptDocuments>& documents() const { return documents_; }
  /// The diagram as the library has it, which keeps `of` alive.
  static Model library_model(const std::shared_ptr<const LoadedFile>& of);

  /// A session that nothing else uses, until it is given back: it keeps what its calls can share.
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
