#pragma once

#include <string>

namespace stepwire::cli {

/// Whether what is printed has colours: on terminals, unless NO_COLOR has a value or TERM is dumb; or as the
/// call says.
enum class Color { automatic, always, never };

/// How a call prints, for all of its verbs alike.
struct ConsoleStyle {
  bool quiet = false;  ///< only errors, failures, and the data that the call is for
  Color color = Color::automatic;
  bool data_only = false;  ///< the standard output has data: text for people goes to the standard error
};

/// Of this process.
ConsoleStyle& console_style();

/// Whether what goes to a stream (STDOUT_FILENO, STDERR_FILENO) has colours.
bool has_colors(int stream);

/// A text of whole lines with colours at the begin of verdicts, notes, and errors with their place.
std::string painted(const std::string& text);

}  // namespace stepwire::cli
