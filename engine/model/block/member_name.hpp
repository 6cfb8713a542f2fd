#pragma once

#include <string_view>

namespace stepwire {

/// Returns the C++ name of a member from its pointer: member_identifier<&Switch::else_>() is "else_".
template <auto member>
constexpr std::string_view member_identifier() {
  constexpr std::string_view text = __PRETTY_FUNCTION__;
  constexpr std::size_t mark = text.find("member = ");
  constexpr std::size_t end = text.find_first_of(";]", mark);
  constexpr std::size_t start = text.rfind("::", end) + 2;
  return text.substr(start, end - start);
}

/// Returns its name in files: a trailing '_' (for names that are keywords of C++) is dropped.
template <auto member>
constexpr std::string_view member_name() {
  constexpr std::string_view name = member_identifier<member>();
  return name.back() == '_' ? name.substr(0, name.size() - 1) : name;
}

}  // namespace stepwire
