#include <fmt/format.h>

#include "engine/app/cli/commands.hpp"
#include "engine/app/cli/console.hpp"
#include "engine/app/reference/format_page.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire {

ExitCode show_format(const FormatCommand& command) {
  if (command.section.empty()) {
    put_data(command.markdown ? formats_markdown() : format_list());
    return ExitCode::done;
  }
  const Section* section = find_section(command.section);
  if (!section) {
    std::vector<std::string> names;
    for (const Section& one : format_sections()) names.push_back(one.name);
    complain("there is no section '{}'{}\n", visible(command.section),
             did_you_mean(command.section, names, "'stepwire format' lists them"));
    return ExitCode::wrong;
  }
  put_data(command.markdown ? format_markdown(*section) : format_page(*section));
  return ExitCode::done;
}

}  // namespace stepwire
