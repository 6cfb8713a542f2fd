#include "engine/app/reference/part_reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "engine/app/reference/sheet_text.hpp"
#include "engine/base/yaml/yaml_text.hpp"

namespace stepwire::reference {

namespace {

namespace fs = std::filesystem;

std::string declared_text(const yaml::Node& map, const char* key) {
  const yaml::Node* value = map.is_map() ? map.find(key) : nullptr;
  if (!value) return "";
  return value->is_scalar() ? value->text : yaml::yaml_line(*value);
}

std::string value_line(const yaml::Node& node) {
  return node.is_scalar() ? node.text : yaml::yaml_line(node);
}

/// Returns the limits of a parameter such as "above 0 N, at most 5 N".
std::string limits_text(const yaml::Node& parameter) {
  std::string limits;
  for (const char* key : {"above", "at_least", "below", "at_most"})
    if (const std::string limit = declared_text(parameter, key); !limit.empty()) {
      std::string words = key;
      std::ranges::replace(words, '_', ' ');
      limits += (limits.empty() ? "" : ", ") + words + " " + limit;
    }
  return limits;
}

ReferenceTable part_parameters(const yaml::Node& root) {
  ReferenceTable table{"Parameters", {"name", "default", "allowed", "meaning"}, {}};
  if (const yaml::Node* parameters = root.find("parameters"))
    for (const yaml::Entry& entry : parameters->entries) {
      const bool told = entry.value.is_map() && entry.value.find("value");
      table.rows.push_back({entry.key, told ? declared_text(entry.value, "value") : value_line(entry.value),
                            limits_text(entry.value), declared_text(entry.value, "doc")});
    }
  return table;
}

ReferenceTable part_inputs(const yaml::Node& root) {
  ReferenceTable table{"Inputs", {"name", "unit", "default", "meaning"}, {}};
  if (const yaml::Node* inputs = root.find("inputs"))
    for (const yaml::Entry& entry : inputs->entries)
      table.rows.push_back({entry.key, declared_text(entry.value, "unit"), declared_text(entry.value, "default"),
                            declared_text(entry.value, "doc")});
  return table;
}

ReferenceTable part_outputs(const yaml::Node& root) {
  ReferenceTable table{"Outputs", {"name", "unit", "signal", "meaning"}, {}};
  if (const yaml::Node* outputs = root.find("outputs"))
    for (const yaml::Entry& entry : outputs->entries)
      table.rows.push_back({entry.key, declared_text(entry.value, "unit"),
                            entry.value.is_scalar() ? entry.value.text : declared_text(entry.value, "signal"),
                            declared_text(entry.value, "doc")});
  return table;
}

/// Returns the comment below the title, without its indented lines, which are drawings.
std::string comment_below_title(const std::string& text) {
  std::istringstream lines(text);
  std::string all;
  bool begun = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#")) {
      begun = true;
      if (line.starts_with("# ") && !line.starts_with("#  "))
        all += (all.empty() ? "" : " ") + line.substr(2);
    } else if (begun) {
      break;
    }
  }
  return all;
}

std::string part_example(const yaml::Node& root, const std::string& file) {
  std::string line = fmt::format("{}: {{diagram: {}", fs::path(file).stem().string(), file);
  if (const yaml::Node* inputs = root.find("inputs"))
    for (const yaml::Entry& entry : inputs->entries)
      if (!entry.value.is_map() || !entry.value.find("default"))
        line += fmt::format(", {}: {}", entry.key, entry.key);
  return line + "}";
}

}  // namespace

BlockReference part_reference(const yaml::Document& document, const std::string& text) {
  const yaml::Node& root = document.root;
  BlockReference sheet{
      fs::path(document.file).stem().string(), "part", declared_text(root, "title"), {}, {}, "", ""};
  if (const std::string comment = comment_below_title(text); !comment.empty()) sheet.doc += ". " + comment;
  sheet.facts.emplace_back("file", document.file);
  sheet.example = part_example(root, document.file);
  for (ReferenceTable table : {part_parameters(root), part_inputs(root), part_outputs(root)}) {
    if (table.rows.empty()) continue;
    drop_empty_columns(table);
    sheet.tables.push_back(std::move(table));
  }
  return sheet;
}

std::string part_list(const std::vector<yaml::Document>& documents) {
  std::size_t widest = 0;
  for (const yaml::Document& document : documents) widest = std::max(widest, width(document.file));
  std::string list;
  for (const yaml::Document& document : documents)
    list += "  " + padded(document.file, widest) + "  " + declared_text(document.root, "title") + "\n";
  return list;
}

}  // namespace stepwire::reference
