#include "engine/view/render/gnuplot_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/text/characters.hpp"
#include "engine/view/svg/svg.hpp"

namespace stepwire::render {
namespace {

/// Returns the blank nearest to the middle; npos without one.
std::size_t middle_blank(const std::string& text) {
  std::size_t best = std::string::npos;
  const auto far = [&](std::size_t at) {
    return std::abs(static_cast<double>(2 * at) - static_cast<double>(text.size()));
  };
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at + 1))
    if (best == std::string::npos || far(at) < far(best)) best = at;
  return best;
}

}  // namespace

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text::printable(text)) {
    if (c == '\'')
      result += "’";  // gnuplot reads two as one, but not at the beginning
    else
      result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  text::replace_all(result, "]]>", "]] >");  // gnuplot would copy it, and XML forbids it
  return result + "'";
}

std::string quoted_tic(const std::string& text) {
  std::string result = quoted(text);
  text::replace_all(result, "%", "%%");
  return result;
}

std::string fitted_title(const std::string& text, double room) {
  constexpr double usual = 14.0, least = 11.0;
  double size = svg::fitted_size(text, usual, room);
  const std::size_t blank = middle_blank(text);
  std::string title = quoted(text);
  if (size < least && blank != std::string::npos) {
    const std::string first = text.substr(0, blank), second = text.substr(blank + 1);
    size = std::min(svg::fitted_size(first, usual, room), svg::fitted_size(second, usual, room));
    // In double quotes gnuplot would execute text in backquotes.
    title = fmt::format(R"(sprintf("%s\n%s", {}, {}))", quoted(first), quoted(second));
  }
  return size < usual ? title + fmt::format(" font ',{:.1f}'", size) : title;
}

}  // namespace stepwire::render
