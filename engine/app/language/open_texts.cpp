#include "engine/app/language/open_texts.hpp"

#include <filesystem>
#include <utility>

#include "engine/base/io/file.hpp"

namespace stepwire::language {

namespace fs = std::filesystem;

void OpenTexts::open(const std::string& path, std::string text) {
  open_[path] = {std::nullopt, std::make_shared<const std::string>(std::move(text))};
  ++changes_;
}

void OpenTexts::open_tree(const std::string& path, std::shared_ptr<const yaml::Document> document) {
  open_[path] = {std::nullopt, text(path), std::move(document)};
  ++changes_;
}

void OpenTexts::close(const std::string& path) {
  open_.erase(path);
  last_.erase(path);
  ++changes_;
}

std::vector<std::string> OpenTexts::open_paths() const {
  std::vector<std::string> paths;
  for (const auto& [path, file] : open_) paths.push_back(path);
  return paths;
}

std::shared_ptr<const std::string> OpenTexts::text(const std::string& path) {
  File& found = file(path);
  if (!found.text) {
    try {
      found.text = std::make_shared<const std::string>(read(path));
    } catch (const std::exception&) {  // reported when the file is parsed
      found.text = std::make_shared<const std::string>();
    }
  }
  return found.text;
}

std::string OpenTexts::read(const std::string& path) const {
  return access_.read ? access_.read(path) : io::read_file(path);
}

yaml::Document OpenTexts::parsed(const std::string& path, const File& file) const {
  const bool is_open = !file.stamp;
  yaml::Document document = is_open        ? yaml::parse_document(*file.text, path)
                            : access_.read ? yaml::parse_document(access_.read(path), path)
                                           : yaml::read_document(path);
  if (access_.check) access_.check(document);
  return document;
}

std::shared_ptr<const yaml::Document> OpenTexts::document(const std::string& path) {
  File& found = file(path);
  if (found.error) throw yaml::Error(*found.error);
  if (found.document) return found.document;
  try {
    found.document = std::make_shared<const yaml::Document>(parsed(path, found));
  } catch (const yaml::Error& error) {
    found.error = std::make_shared<const yaml::Error>(error);
    throw;
  }
  return last_[path] = found.document;
}

std::shared_ptr<const yaml::Document> OpenTexts::last_document(const std::string& path) {
  try {
    return document(path);
  } catch (const yaml::Error&) {
    const auto last = last_.find(path);
    return last == last_.end() ? nullptr : last->second;
  }
}

diagram::DocumentReader OpenTexts::reader() {
  return [this](const std::string& path, const yaml::DocumentLimits&) { return document(path); };
}

OpenTexts::OnDisk OpenTexts::stamp_of(const std::string& path) {
  std::error_code none;
  const auto time = fs::last_write_time(path, none).time_since_epoch().count();
  if (none) return {};
  return {static_cast<std::int64_t>(time), fs::file_size(path, none)};
}

OpenTexts::File& OpenTexts::file(const std::string& path) {
  if (const auto found = open_.find(path); found != open_.end()) return found->second;
  const OnDisk now = stamp_of(path);
  File& kept = on_disk_[path];
  if (kept.stamp != now) kept = {now};
  return kept;
}

}  // namespace stepwire::language
