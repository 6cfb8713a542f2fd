#include "engine/model/diagram/unused.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace stepwire::diagram {

namespace {

bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// True where the name is a word of the text, with or without '$'.
bool mentions(const std::string& text, const std::string& name) {
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const bool begins = at == 0 || (!is_word(text[at - 1]) && text[at - 1] != '.');
    if (begins && (at + name.size() == text.size() || !is_word(text[at + name.size()]))) return true;
  }
  return false;
}

/// True for keys with texts for readers.
bool is_prose(const std::string& key) {
  return key == "that" || key == "title" || key == "label" || key == "caption" || key == "doc" ||
         key == "text";
}

bool mentions(const yaml::Node& node, const std::string& name) {
  const auto in = [&](const yaml::Node& child) { return mentions(child, name); };
  return mentions(node.text, name) || std::any_of(node.items.begin(), node.items.end(), in) ||
         std::any_of(node.entries.begin(), node.entries.end(), [&](const yaml::Entry& entry) {
           return is_prose(entry.key) ? mentions(entry.value.text, "$" + name) : in(entry.value);
         });
}

/// True for uses in figures, scenes, claims, fits, tunings and studies, which read parameters only after the
/// diagram is built.
bool is_drawn_or_claimed(const yaml::Node& root, const std::string& name) {
  for (const char* key : {"figure", "scene", "claims", "invariants", "fit", "tune", "study", "sensitivity"})
    if (const yaml::Node* node = root.find(key); node && mentions(*node, name)) return true;
  const yaml::Node* sweep = root.find("sweep");
  const yaml::Node* one = sweep ? sweep->find("one_at_a_time") : nullptr;
  const yaml::Node* keep = sweep ? sweep->find("keep") : nullptr;
  return sweep && (sweep->find(name) || (one && one->find(name)) || (keep && mentions(*keep, name)));
}

void refuse_unused(const Scope& scope, std::set<const yaml::Document*>& seen, Report& report) {
  if (!seen.insert(scope.document).second) return;  // a part used twice is reported once
  const yaml::Node& root = scope.document->root;
  if (const yaml::Node* parameters = root.find("parameters"))
    for (const yaml::Entry& entry : parameters->entries)
      if (!scope.parameters.used(entry.key) && !is_drawn_or_claimed(root, entry.key))
        report.add(scope.at(entry.mark), scope.prefix + entry.key,
                   fmt::format("nothing uses this parameter; use it as ${}, or take it out", entry.key));
  for (const auto& [name, named] : scope.names)
    if (named.part) refuse_unused(*named.part, seen, report);
}

}  // namespace

void refuse_unused_parameters(const Scope& scope, Report& report) {
  std::set<const yaml::Document*> seen;
  refuse_unused(scope, seen, report);
}

}  // namespace stepwire::diagram
