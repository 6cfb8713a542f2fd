#include "engine/app/studio/diagram_files.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <set>

#include "engine/app/studio/fault.hpp"
#include "engine/app/studio/named_files.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/io/temporary.hpp"

namespace stepwire::studio {

namespace {

namespace fs = std::filesystem;

constexpr const char* outside =
    "this file does not lie beneath the folders of the diagram and its parts as they were when the studio "
    "was started";

std::string folder_of(const std::string& path) {
  return fs::path(path).parent_path().string();
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
  if (const std::string data = data_folder(); !data.empty()) beneath_.add(data);
  trust(path.string());
}

/// Adds the folders of all files that a diagram names. It runs before any page has edited a text, so that
/// these names are trusted wherever they lead.
void DiagramFiles::trust(const std::string& file) {
  if (!trusted_.insert(file).second) return;
  beneath_.add(folder_of(file));
  try {
    for (const NamedFile& named : named_files(yaml::read_document(file)))
      if (named.is_diagram)
        trust(named.path);
      else
        beneath_.add(folder_of(named.path));
  } catch (const yaml::Error&) {  // reported when the file is opened
  }
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

std::string DiagramFiles::name(const std::string& path) const {
  return path.starts_with('/') ? fs::path(path).lexically_relative(folder_of(paths_.front())).string() : path;
}

std::string DiagramFiles::text(const std::string& path) {
  const EditedText* edited = texts_.find(path);
  return edited ? edited->text : beneath_.read(path).text;
}

void DiagramFiles::require_inside(const yaml::Document& document) const {
  yaml::Faults faults;
  for (const NamedFile& named : named_files(document))
    if (!named.is_plain || !beneath_.holds(named.path))
      faults.add({{document.file, named.mark}, "", outside, {}});
  faults.throw_if_any();
}

language::FileAccess DiagramFiles::access() const {
  const auto read = [this](const std::string& path) {
    try {
      return beneath_.read(path).text;
    } catch (const Fault& fault) {
      throw yaml::Error({{path, {}}, "", fault.what(), {}});
    }
  };
  return {read, [this](const yaml::Document& document) { require_inside(document); }};
}

std::vector<yaml::Document> DiagramFiles::documents(const std::string& path) {
  std::vector<yaml::Document> all;
  std::set<std::string> seen;
  const std::function<void(const std::string&)> read = [&](const std::string& one) {
    if (!seen.insert(one).second) return;
    all.push_back(yaml::parse_document(text(one), one));
    require_inside(all.back());
    for (const NamedFile& named : named_files(all.back()))
      if (named.is_diagram) read(named.path);
  };
  read(path);
  return all;
}

std::vector<ListedFile> DiagramFiles::list() {
  std::set<std::string> parts;
  try {
    for (const yaml::Document& document : documents(paths_.front())) parts.insert(document.file);
  } catch (const std::exception&) {  // the file has faults now; its known parts remain listed
  }
  for (const std::string& part : parts) number(part);
  std::error_code none;
  std::set<std::string> beside;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_of(paths_.front()), none))
    if (is_diagram(entry)) beside.insert(entry.path().string());
  for (const std::string& one : beside) number(one);
  std::vector<ListedFile> files;
  for (std::size_t i = 0; i < paths_.size(); ++i)
    files.push_back({static_cast<int>(i), name(paths_[i]), beneath_.is_writable(paths_[i]),
                     i > 0 && parts.contains(paths_[i])});
  return files;
}

}  // namespace stepwire::studio
