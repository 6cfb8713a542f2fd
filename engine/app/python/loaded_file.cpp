#include "engine/app/python/loaded_file.hpp"

#include "engine/stepwire/content.hpp"

namespace stepwire::python {

namespace {

session::LoadOptions options_of(const LoadCall& call, const std::shared_ptr<KeptDocuments>& documents) {
  session::LoadOptions options;
  options.settings = call.settings;
  options.stop = call.stop;
  options.reader = reader_of(documents, call.file, call.sections);
  return options;
}

}  // namespace

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
