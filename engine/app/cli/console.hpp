#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string_view>
#include <utility>

#include "engine/base/json/json.hpp"

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

/// Writes data to the standard output, byte for byte. None of these functions throws; finish_output() reports
/// a full disk or a closed pipe.
void put_data(std::string_view data);

/// Writes a JSON result to the standard output.
inline void put_json(const json::Json& result) {
  put_data(result.text() + "\n");
}

/// Writes text to the standard output, with control characters escaped. A quiet call drops it. If the
/// standard output has data, the text goes to the standard error.
void put_text(std::string_view text);
/// Writes the text of a failure like put_text(), in a quiet call as well.
void put_failure(std::string_view text);
/// Writes a report as a failure or as plain text.
inline void put_report(std::string_view text, bool failed) {
  failed ? put_failure(text) : put_text(text);
}
/// Writes an error to the standard error.
void put_trouble(std::string_view text);
/// Writes a note to the standard error. A quiet call drops it.
void put_note(std::string_view text);

template <class... Values>
void say(fmt::format_string<Values...> format, Values&&... values) {
  put_text(fmt::format(format, std::forward<Values>(values)...));
}
template <class... Values>
void remark(fmt::format_string<Values...> format, Values&&... values) {
  put_note(fmt::format(format, std::forward<Values>(values)...));
}
template <class... Values>
void complain(fmt::format_string<Values...> format, Values&&... values) {
  put_trouble(fmt::format(format, std::forward<Values>(values)...));
}

/// Flushes the standard output. After a failed write, prints one line on the standard error and returns
/// false. A closed pipe, as of `head`, is no failure.
bool finish_output();

/// Reads at most `most` bytes of the standard input and returns their count; 0 at its end. Interrupted reads
/// continue.
std::size_t read_standard_input(char* to, std::size_t most);

/// Opens closed standard streams on /dev/null. Otherwise the next opened file would get the descriptor and
/// the output. The mode is chosen so that reading or writing fails.
void fill_standard_streams();

}  // namespace stepwire::cli
