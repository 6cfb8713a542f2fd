#include "engine/app/studio/diagram_files.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <set>

#include "engine/app/studio/fault.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/io/temporary.hpp"

namespace stepwire::studio {

namespace {

namespace fs = std::filesystem;

std::string folder_of(const std::string& path) {
  return fs::path(path).parent_path().string();
}

/// A part of a diagram: the path that stands there, from the folder of the diagram.
struct PartName {
  std::string path;
  yaml::Mark mark;
};

void find_parts(const yaml::Node& node, const std::string& file, std::vector<PartName>& found) {
  for (const yaml::Entry& entry : node.entries) {
    if (entry.key == "diagram" && entry.value.is_scalar() && !entry.value.text.empty())
      found.push_back(
          {(fs::path(file).parent_path() / entry.value.text).lexically_normal().string(), entry.value.mark});
    find_parts(entry.value, file, found);
  }
  for (const yaml::Node& item : node.items) find_parts(item, file, found);
}

std::vector<PartName> parts_of(const yaml::Document& document) {
  std::vector<PartName> found;
  find_parts(document.root, document.file, found);
  return found;
}

bool exists(const std::string& path) {
  std::error_code none;
  return fs::exists(path, none);
}

bool is_diagram(const fs::directory_entry& entry) {
  std::error_code none;
  const std::string ending = entry.path().extension().string();
  return (ending == ".yaml" || ending == ".yml") && entry.is_regular_file(none);
}

}  // namespace

DiagramFiles::DiagramFiles(const std::string& file, DraftStore store) : texts_(beneath_, std::move(store)) {
  std::error_code error;
  const fs::path path = fs::canonical(file, error);
  if (error) io::refuse_file(file, error.value());
  io::read_file(path.string());
  number(path.string());
  beneath_.add(folder_of(path.string()));
  // As the files are now, before any page has changed them, their parts may lie where they do.
  std::set<std::string> seen;
  const std::function<void(const std::string&)> trust = [&](const std::string& one) {
    if (!seen.insert(one).second || !exists(one)) return;
    beneath_.add(folder_of(one));
    try {
      for (const PartName& part : parts_of(yaml::read_document(one))) trust(part.path);
    } catch (const yaml::Error&) {  // is shown when it is opened
    }
  };
  trust(path.string());
}

int DiagramFiles::number(const std::string& path) {
  const auto [found, is_new] = numbers_.try_emplace(path, static_cast<int>(paths_.size()));
  if (is_new) paths_.push_back(path);
  return found->second;
}

const std::string& DiagramFiles::path(int number) const {
  if (number < 0 || number >= std::ssize(paths_))
    throw Fault("there is no file of this number; 'files' lists them");
  return paths_[static_cast<std::size_t>(number)];
}

std::string DiagramFiles::text(const std::string& path) {
  const EditedText* edited = texts_.find(path);
  return edited ? edited->text : beneath_.read(path).text;
}

std::vector<yaml::Document> DiagramFiles::documents(const std::string& path) {
  std::vector<yaml::Document> all;
  std::set<std::string> seen;
  const std::function<void(const std::string&)> read = [&](const std::string& one) {
    if (!seen.insert(one).second) return;
    all.push_back(yaml::parse_document(text(one), one));
    const std::vector<PartName> parts = parts_of(all.back());
    for (const PartName& part : parts) {
      if (!exists(part.path)) continue;  // the loader says so
      if (!beneath_.holds(part.path))
        throw yaml::Error({{one, part.mark},
                           "",
                           "this file does not lie beneath the folders of the diagram and its parts as "
                           "they were when the studio was started",
                           {}});
      read(part.path);
    }
  };
  read(path);
  return all;
}

std::vector<ListedFile> DiagramFiles::list() {
  std::set<std::string> parts;
  try {
    for (const yaml::Document& document : documents(paths_.front())) parts.insert(document.file);
  } catch (const std::exception&) {  // it does not load just now; what was known stays
  }
  for (const std::string& part : parts) number(part);
  std::error_code none;
  std::set<std::string> beside;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_of(paths_.front()), none))
    if (is_diagram(entry)) beside.insert(entry.path().string());
  for (const std::string& one : beside) number(one);
  std::vector<ListedFile> files;
  const fs::path folder = folder_of(paths_.front());
  for (std::size_t i = 0; i < paths_.size(); ++i)
    files.push_back({static_cast<int>(i), fs::path(paths_[i]).lexically_relative(folder).string(),
                     beneath_.is_writable(paths_[i]), i > 0 && parts.contains(paths_[i])});
  return files;
}

}  // namespace stepwire::studio
