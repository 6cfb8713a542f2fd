#include "engine/app/python/kept_documents.hpp"

#include <algorithm>

namespace stepwire::python {

namespace {

void put_section(yaml::Node& root, const yaml::Entry& section) {
  const auto known = std::ranges::find(root.entries, section.key, &yaml::Entry::key);
  if (known == root.entries.end())
    root.entries.push_back(section);
  else
    known->value = section.value;
}

}  // namespace

std::shared_ptr<const yaml::Document> KeptDocuments::read(const std::string& path,
                                                          const yaml::DocumentLimits& limits) {
  const std::lock_guard lock(mutex_);
  auto& document = documents_[path];
  if (!document) document = std::make_shared<const yaml::Document>(yaml::read_document(path, limits));
  return document;
}

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

}  // namespace stepwire::python
