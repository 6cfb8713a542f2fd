#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/reference/format_page.hpp"
#include "engine/app/reference/result_page.hpp"
#include "engine/app/report/results.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::cli {

namespace {

struct FormatCall {
  std::string section;  ///< empty: all sections
  bool markdown = false, python = false, typescript = false;
};

const std::string of_results = "results.";

std::string list_of_all() {
  std::string list = reference::format_list();
  for (const report::JobResult& one : report::job_results())
    list += fmt::format("  {:<20}  {}\n", of_results + one.job, one.type.doc);
  return list;
}

std::string all_markdown() {
  std::string page = reference::formats_markdown() + "\n# The results of jobs\n";
  for (const report::JobResult& one : report::job_results())
    page += "\n" + reference::result_markdown(one.type, 2);
  return page;
}

/// Returns the page of a section or of a result; "" if there is none of this name.
std::string page_of(const FormatCall& call) {
  for (const report::JobResult& one : report::job_results())
    if (of_results + one.job == call.section)
      return call.markdown ? reference::result_markdown(one.type) : reference::result_page(one.type);
  const reference::Section* section = reference::find_section(call.section);
  if (!section) return "";
  return call.markdown ? reference::format_markdown(*section) : reference::format_page(*section);
}

ExitCode refuse(const std::string& section) {
  std::vector<std::string> names;
  for (const reference::Section& one : reference::format_sections()) names.push_back(one.name);
  for (const report::JobResult& one : report::job_results()) names.push_back(of_results + one.job);
  complain("there is no section '{}'{}\n", text::visible(section),
           yaml::did_you_mean(section, names, "'stepwire format' lists them").text());
  return ExitCode::wrong;
}

ExitCode show_format(const FormatCall& call) {
  if (call.python || call.typescript) {
    put_data(call.python ? report::results_stub() : report::results_typescript());
    return ExitCode::done;
  }
  const std::string page = !call.section.empty() ? page_of(call)
                           : call.markdown       ? all_markdown()
                                                 : list_of_all();
  if (page.empty()) return refuse(call.section);
  put_data(page);
  return ExitCode::done;
}

Action declare_format(CLI::App& verb) {
  const auto call = std::make_shared<FormatCall>();
  CLI::Option* section = verb.add_option("SECTION", call->section,
                                         "a section, a kind of plot: figure.lines, or a result: results.fit");
  CLI::Option* markdown = verb.add_flag("--markdown", call->markdown, "as Markdown");
  CLI::Option* typescript =
      verb.add_flag("--typescript", call->typescript, "types of all results in TypeScript");
  typescript->excludes(section)->excludes(markdown);
  verb.add_flag("--python", call->python, "types of all results in Python, as a stub")
      ->excludes(section)
      ->excludes(markdown)
      ->excludes(typescript);
  return [call](const Registry&) { return show_format(*call); };
}

}  // namespace

Verb format_verb() {
  return {"format", "list the sections of a diagram file and the results of jobs, or explain one",
          "Example:\n  stepwire format claims\n  stepwire format results.fit\n"
          "  stepwire format --markdown > format.md",
          declare_format};
}

}  // namespace stepwire::cli
