#pragma once

#include <string>

namespace stepwire::cli {

/// Colour mode of the output. Automatic: colours on terminals, unless NO_COLOR is set or TERM is dumb.
enum class Color { automatic, always, never };

/// Output options of a call, the same for all verbs.
struct ConsoleStyle {
  bool quiet = false;  ///< only errors, failures and the requested data
  Color color = Color::automatic;
  bool data_only = false;  ///< the standard output is data; text goes to the standard error
};

/// Returns the style of this process.
ConsoleStyle& console_style();

/// True if output to a stream (STDOUT_FILENO, STDERR_FILENO) is coloured.
bool has_colors(int stream);

/// Colours the starts of lines that are verdicts, notes, or errors with a location. The text must have whole
/// lines.
std::string painted(const std::string& text);

}  // namespace stepwire::cli
