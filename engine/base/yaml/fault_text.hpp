#pragma once

#include <fmt/format.h>

#include <string>

#include "engine/base/yaml/error.hpp"

namespace stepwire::yaml {

/// Formats a message with texts of users in it: the first "; " of the form itself becomes the cure mark.
template <class... Values>
std::string fault_text(fmt::format_string<Values...> form, Values&&... values) {
  std::string marked{fmt::string_view(form).data(), fmt::string_view(form).size()};
  if (const std::size_t at = marked.find("; "); at != marked.npos) marked.replace(at, 2, 1, cure_mark);
  return fmt::vformat(marked, fmt::make_format_args(values...));
}

}  // namespace stepwire::yaml
