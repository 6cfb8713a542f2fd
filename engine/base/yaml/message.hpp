#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

namespace stepwire::yaml {

/// A word of a file that means nothing there, and the one near it that does.
struct Suggestion {
  std::string written, meant;
  bool operator==(const Suggestion&) const = default;
};

/// What is wrong in words, what would be right, and as data the word that was probably meant.
class Message {
 public:
  Message() = default;
  /// Takes "what is wrong; what would be right" apart at the first "; " outside of quotes. A text that holds
  /// words of a user, in which "; " may occur, is made by fault_text().
  Message(const std::string& text);
  Message(const char* text) : Message(std::string(text)) {}
  Message(std::string what_is_wrong, std::string what_cures, std::optional<Suggestion> offered = {})
      : wrong(std::move(what_is_wrong)), cure(std::move(what_cures)), suggestion(std::move(offered)) {}

  bool empty() const { return wrong.empty() && cure.empty(); }
  /// "what is wrong; what would be right".
  std::string text() const { return cure.empty() ? wrong : wrong + "; " + cure; }
  /// More behind the last of both.
  Message& operator+=(const std::string& more);
  bool operator==(const Message&) const = default;

  std::string wrong;
  std::string cure;  ///< empty where nothing is known
  std::optional<Suggestion> suggestion;
};

/// What is wrong begins with this text.
Message operator+(const std::string& what, Message rest);

/// Parts a text at the first byte `mark`.
Message parted_at(char mark, const std::string& text);

/// Formats a message with texts of users in it, and parts it at the first "; " of the form itself.
template <class... Values>
Message fault_text(fmt::format_string<Values...> form, Values&&... values) {
  constexpr char mark = '\xff';  // no UTF-8 has this byte
  std::string marked{fmt::string_view(form).data(), fmt::string_view(form).size()};
  if (const std::size_t at = marked.find("; "); at != marked.npos) marked.replace(at, 2, 1, mark);
  return parted_at(mark, fmt::vformat(marked, fmt::make_format_args(values...)));
}

}  // namespace stepwire::yaml
