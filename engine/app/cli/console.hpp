#pragma once

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace stepwire::cli {

/// Puts data on the standard output, byte for byte. Neither this nor the others throw: a full disk or a
/// reader who has left shows in finish_output().
void put_data(std::string_view data);

/// Puts text for people on the standard output; control characters in it are written out.
void put_text(std::string_view text);
/// The same on the standard error.
void put_trouble(std::string_view text);

template <class... Values>
void say(fmt::format_string<Values...> format, Values&&... values) {
  put_text(fmt::format(format, std::forward<Values>(values)...));
}
template <class... Values>
void complain(fmt::format_string<Values...> format, Values&&... values) {
  put_trouble(fmt::format(format, std::forward<Values>(values)...));
}

/// Gives all of the standard output to the system; false, with one line on the standard error, where some of
/// it was not taken.
bool finish_output();

/// A caller may close a standard stream; the first file that is opened then would take its place and get what
/// is printed. Such a stream takes nothing.
void fill_standard_streams();

}  // namespace stepwire::cli
