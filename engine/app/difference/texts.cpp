#include "engine/app/difference/texts.hpp"

#include <filesystem>

#include "engine/base/io/file.hpp"
#include "engine/model/diagram/part_file.hpp"

namespace stepwire::difference {

void Texts::give(const std::string& path, std::string text) {
  yaml::Document document = yaml::parse_document(text, path);
  texts_[path] = std::make_shared<const DiagramText>(DiagramText{std::move(text), std::move(document)});
}

const DiagramText& Texts::read(const std::string& path) {
  if (const auto found = texts_.find(path); found != texts_.end()) return *found->second;
  yaml::Document document = yaml::read_document(path);
  auto& made = texts_[path];
  made = std::make_shared<const DiagramText>(DiagramText{io::read_file(path), std::move(document)});
  return *made;
}

const DiagramText* Texts::find(const std::string& path) {
  try {
    return &read(path);
  } catch (const yaml::Error&) {
    return nullptr;
  }
}

Texts Texts::with(const std::string& path, std::string text) const {
  Texts other = *this;
  other.give(path, std::move(text));
  return other;
}

std::string Texts::part_path(const std::string& user, const std::string& part) {
  const DiagramText* text = find(user);
  if (const auto use = text ? diagram::use_of(text->document.root, part) : std::nullopt)
    return fetched_.problem(*use, user).empty() ? diagram::fetched_file(*use, part) : "";
  const std::string beside = (std::filesystem::path(user).parent_path() / part).lexically_normal().string();
  return texts_.contains(beside) ? beside : diagram::part_file(user, part);
}

}  // namespace stepwire::difference
