#include <CLI/CLI.hpp>
#include <memory>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/reference/format_page.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::cli {

namespace {

struct FormatCall {
  std::string section;  ///< empty: all sections
  bool markdown = false;
};

ExitCode show_format(const FormatCall& call) {
  if (call.section.empty()) {
    put_data(call.markdown ? reference::formats_markdown() : reference::format_list());
    return ExitCode::done;
  }
  const reference::Section* section = reference::find_section(call.section);
  if (!section) {
    std::vector<std::string> names;
    for (const reference::Section& one : reference::format_sections()) names.push_back(one.name);
    complain("there is no section '{}'{}\n", text::visible(call.section),
             yaml::did_you_mean(call.section, names, "'stepwire format' lists them").text());
    return ExitCode::wrong;
  }
  put_data(call.markdown ? reference::format_markdown(*section) : reference::format_page(*section));
  return ExitCode::done;
}

Action declare_format(CLI::App& verb) {
  const auto call = std::make_shared<FormatCall>();
  verb.add_option("SECTION", call->section, "a section, or a kind of plot: figure.lines");
  verb.add_flag("--markdown", call->markdown, "as Markdown");
  return [call](const Registry&) { return show_format(*call); };
}

}  // namespace

Verb format_verb() {
  return {"format", "list the sections of a diagram file, or explain one",
          "Example:\n  stepwire format claims\n  stepwire format --markdown > format.md", declare_format};
}

}  // namespace stepwire::cli
