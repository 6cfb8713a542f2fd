#include "engine/model/diagram/settings.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace stepwire::diagram {

Settings::Settings(const std::vector<Setting>& settings, Report& report) {
  for (const Setting& setting : settings) {
    const std::string& source = setting.written;
    auto& scopes = report.diagram().scopes;
    scopes.push_back({source, "", {-1, {}}});
    const Origin origin{static_cast<int>(scopes.size()) - 1, setting.mark};
    try {
      yaml::Document document = yaml::parse_document(setting.value, source);
      // The location of a setting is the whole setting, not a column of its text.
      document.root.mark = setting.mark;
      entries_[setting.name] = {std::move(document), origin, false};
    } catch (const yaml::Error& error) {
      report.add(origin, setting.name, error.faults().front().message);
    }
  }
}

Settings::Entry* Settings::take(const std::string& full_name) {
  if (entries_.empty()) return nullptr;
  const auto found = entries_.find(full_name);
  if (found == entries_.end()) return nullptr;
  found->second.used = true;
  return &found->second;
}

void Settings::offer(const std::string& full_name) {
  if (!entries_.empty()) offered_.push_back(full_name);
}

bool Settings::set_some(const std::string& key) const {
  return std::ranges::any_of(entries_, [&](const auto& entry) { return entry.first.ends_with("." + key); });
}

std::vector<std::string> Settings::keys_of(const std::string& prefix) const {
  std::vector<std::string> keys;
  for (const auto& [name, entry] : entries_)
    if (name.starts_with(prefix) && name.find('.', prefix.size()) == std::string::npos)
      keys.push_back(name.substr(prefix.size()));
  return keys;
}

void Settings::report_unused(Report& report) const {
  for (const auto& [name, entry] : entries_) {
    if (entry.used) continue;
    yaml::Message cure = yaml::did_you_mean(name, offered_);
    if (cure.empty() && !offered_.empty()) cure = yaml::nearest_or_all(name, offered_, "there are");
    report.add(entry.origin, "", fmt::format("there is no parameter '{}'", name) + cure);
  }
}

}  // namespace stepwire::diagram
