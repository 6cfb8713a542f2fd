#include "engine/analyse/study/section_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace stepwire::study {

SectionKeys::SectionKeys(const std::string& section, const yaml::Node& node, const std::string& file,
                         const yaml::Key& form, diagram::Loader& loader, yaml::Faults& faults)
    : section_(section), form_(form), loader_(loader), faults_(faults) {
  take(node, file);
}

yaml::SectionReading SectionKeys::reading(const std::string& file) const {
  return {section_, [file, &faults = faults_](const yaml::Mark& mark, const std::string& subject,
                                              const yaml::Message& message) {
            faults.add({{file, mark}, subject, message, {}});
          }};
}

void SectionKeys::take(const yaml::Node& node, const std::string& file) {
  const yaml::SectionReading read = reading(file);
  if (!files_.insert(file).second)
    return yaml::below(read, "like").fault(node.mark, "this section is like itself in the end");
  if (!node.is_map()) return read.fault(node.mark, "is a map of keys and values");
  read.check_unknown(node, form_);
  for (const yaml::Entry& entry : node.entries)
    if (form_.find(entry.key) && !find(entry.key) && entry.key != "like")
      keys_.push_back({entry.key, file, entry.mark, &entry.value});
  if (const yaml::Node* like = node.find("like")) take_from(*like, file);
}

void SectionKeys::take_from(const yaml::Node& like, const std::string& file) {
  const std::string path =
      (std::filesystem::path(file).parent_path() / like.text).lexically_normal().string();
  const yaml::SectionReading read = yaml::below(reading(file), "like");
  const yaml::Node* section = nullptr;
  try {
    section = loader_.document(path).root.find(section_);
  } catch (const yaml::Error& error) {
    return read.fault(like.mark, error.faults().front().text());
  }
  if (section) return take(*section, path);
  read.fault(like.mark, fmt::format("{} has no section '{}'", path, section_));
}

const SectionKeys::Given* SectionKeys::find(const std::string& name) const {
  const auto found = std::ranges::find(keys_, name, &Given::name);
  return found == keys_.end() ? nullptr : &*found;
}

}  // namespace stepwire::study
