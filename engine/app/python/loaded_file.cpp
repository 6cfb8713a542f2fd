#include "engine/app/python/loaded_file.hpp"

#include <algorithm>

#include "engine/stepwire/content.hpp"

namespace stepwire::python {
namespace {

void put_section(yaml::Node& root, const yaml::Entry& section) {
  const auto known = std::ranges::find(root.entries, section.key, &yaml::Entry::key);
  if (known == root.entries.end())
    root.entries.push_back(section);
  else
    known->value = section.value;
}

/// Returns a reader of cached documents. In `file`, the given sections replace those of the same name.
diagram::DocumentReader reader_of(std::shared_ptr<KeptDocuments> documents, std::string file,
                                  std::vector<yaml::Entry> sections) {
  return [documents = std::move(documents), file = std::move(file), sections = std::move(sections)](
             const std::string& path, const yaml::DocumentLimits& limits) {
    auto document = documents->read(path, limits);
    if (path != file || sections.empty()) return document;
    yaml::Document changed = *document;
    for (const yaml::Entry& section : sections) put_section(changed.root, section);
    return std::make_shared<const yaml::Document>(std::move(changed));
  };
}

session::LoadOptions options_of(const LoadCall& call, const std::shared_ptr<KeptDocuments>& documents) {
  session::LoadOptions options;
  options.settings = call.settings;
  options.stop = call.stop;
  options.reader = reader_of(documents, call.file, call.sections);
  return options;
}

}  // namespace

std::shared_ptr<const yaml::Document> KeptDocuments::read(const std::string& path,
                                                          const yaml::DocumentLimits& limits) {
  const std::lock_guard lock(mutex_);
  auto& document = documents_[path];
  if (!document) document = std::make_shared<const yaml::Document>(yaml::read_document(path, limits));
  return document;
}

LoadedFile::LoadedFile(std::shared_ptr<const Kinds> kinds, std::shared_ptr<KeptDocuments> documents,
                       LoadCall call)
    : kinds_(std::move(kinds)),
      documents_(std::move(documents)),
      call_(std::move(call)),
      model_(session::load_model(kinds_->registry, call_.file, options_of(call_, documents_))) {}

Model LoadedFile::library_model(const File& of) {
  const std::lock_guard lock(of->mutex_);
  auto content = of->content_.lock();
  if (!content) {
    content = std::make_shared<const Model::Content>(std::shared_ptr<const run::Job>(of, &of->model_.job));
    of->content_ = content;
  }
  return Model(std::move(content));
}

std::unique_ptr<session::Session> LoadedFile::take_session() const {
  const std::lock_guard lock(mutex_);
  if (idle_.empty()) return std::make_unique<session::Session>(kinds_->registry);
  auto session = std::move(idle_.back());
  idle_.pop_back();
  return session;
}

void LoadedFile::give_back(std::unique_ptr<session::Session> session) const {
  session->monitor() = {};
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(session));
}

}  // namespace stepwire::python
