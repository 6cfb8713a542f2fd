#include "engine/app/language/section_edits.hpp"

#include <fmt/format.h>

namespace stepwire::language {

namespace {

std::string free_name(const yaml::Document& document, const std::string& section, const std::string& wanted) {
  std::string name = wanted;
  for (int i = 2; DiagramFiles::entry(document, section.c_str(), name); ++i)
    name = fmt::format("{}{}", wanted, i);
  return name;
}

}  // namespace

std::string cut_loop(TreeEdits& edits, const yaml::Document& document, const CutLoop& edit) {
  const std::string name = free_name(document, "linear", "loop"), &signal = edit.signal;
  const std::string at = edit.at.empty() ? "" : ", at: " + edit.at;
  const auto add_analysis = [&] {
    edits.add_below(document.root, "linear", name,
                    fmt::format("{{from: {0}, to: {0}, open: {0}{1}}}", signal, at));
  };
  // An existing section is extended first, because new sections are inserted at the end of the last one.
  const bool has_figure = document.root.find("figure") != nullptr;
  if (!has_figure) add_analysis();
  edits.add_below(document.root, "figure", "",
                  fmt::format("{{plot: bode, of: {}, title: The loop cut behind {}}}", name, signal));
  if (has_figure) add_analysis();
  return name;
}

}  // namespace stepwire::language
