#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

namespace stepwire::yaml {

/// A misspelt word of a file and the known word nearest to it.
struct Suggestion {
  std::string written, meant;
  bool operator==(const Suggestion&) const = default;
};

/// Text of a fault: the problem, the cure, and the likely intended word as data.
class Message {
 public:
  Message() = default;
  /// Splits "problem; cure" at the first "; " outside of quotes. Texts with words of a user, which may
  /// contain "; ", are made by fault_text().
  Message(const std::string& text);
  Message(const char* text) : Message(std::string(text)) {}
  Message(std::string what_is_wrong, std::string what_cures, std::optional<Suggestion> offered = {})
      : wrong(std::move(what_is_wrong)), cure(std::move(what_cures)), suggestion(std::move(offered)) {}

  bool empty() const { return wrong.empty() && cure.empty(); }
  /// Returns "problem; cure".
  std::string text() const { return cure.empty() ? wrong : wrong + "; " + cure; }
  /// Appends text to the cure if there is one, else to the problem.
  Message& operator+=(const std::string& more);
  bool operator==(const Message&) const = default;

  std::string wrong;
  std::string cure;  ///< empty if unknown
  std::optional<Suggestion> suggestion;
};

/// Prefixes the problem of a message.
Message operator+(const std::string& what, Message rest);

/// Splits a text at the first byte `mark`.
Message parted_at(char mark, const std::string& text);

/// Formats a message with texts of users in it, and splits it at the first "; " of the format string itself.
template <class... Values>
Message fault_text(fmt::format_string<Values...> form, Values&&... values) {
  constexpr char mark = '\xff';  // this byte never occurs in UTF-8
  std::string marked{fmt::string_view(form).data(), fmt::string_view(form).size()};
  if (const std::size_t at = marked.find("; "); at != marked.npos) marked.replace(at, 2, 1, mark);
  return parted_at(mark, fmt::vformat(marked, fmt::make_format_args(values...)));
}

}  // namespace stepwire::yaml
