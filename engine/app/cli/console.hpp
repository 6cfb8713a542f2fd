#pragma once

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "engine/base/json/json.hpp"

namespace stepwire::cli {

/// Puts data on the standard output, byte for byte. Neither this nor the others throw: a full disk or a
/// reader who has left shows in finish_output().
void put_data(std::string_view data);

/// Puts a result for programs there.
inline void put_json(const json::Json& result) {
  put_data(result.text() + "\n");
}

/// Puts text for people on the standard output; control characters in it are written out. A quiet call has
/// none, and one whose standard output is data has it on the standard error.
void put_text(std::string_view text);
/// The same of what failed, in a quiet call too.
void put_failure(std::string_view text);
/// One or the other.
inline void put_report(std::string_view text, bool failed) {
  failed ? put_failure(text) : put_text(text);
}
/// Errors, on the standard error.
void put_trouble(std::string_view text);
/// What is no error, on the standard error; nothing in a quiet call.
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

/// Gives all of the standard output to the system; false, with one line on the standard error, where some of
/// it was not taken. A reader who has left, such as `head`, has what it needs.
bool finish_output();

/// A caller may close a standard stream; the first file that is opened then would take its place and get what
/// is printed. Such a stream takes nothing.
void fill_standard_streams();

}  // namespace stepwire::cli
