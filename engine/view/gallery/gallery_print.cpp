#include "engine/view/gallery/gallery_print.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "engine/view/svg/svg.hpp"

namespace stepwire::gallery {
namespace {

// Sizes in pixels of the picture.
constexpr double margin = 30.0, letter = 14.0, line_height = 20.0, narrowest = 560.0, widest_text = 760.0;
/// Width of bold letters relative to regular ones.
constexpr double bold = 1.12;

std::string label_of(const GalleryEntry& entry, const GalleryPicture& picture) {
  const std::string& name = entry.label.empty() ? entry.title : entry.label;
  return picture.own ? name + ", not in the thesis." : name + ".";
}

std::string words_of(const GalleryEntry& entry, const GalleryPicture& picture) {
  std::string words = picture.own ? picture.title : entry.source_caption;
  if (words.empty() && picture.caption.empty() && !entry.label.empty()) words = entry.title;
  if (!words.empty() && !picture.caption.empty()) words += words.ends_with('.') ? " " : ". ";
  return words + picture.caption;
}

/// Breaks words into lines of a width in pixels; the first line begins after a label.
std::vector<std::string> lines_of(const std::string& words, double label, double width) {
  std::vector<std::string> lines{""};
  std::istringstream stream(words);
  for (std::string word; stream >> word;) {
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    const double room = width - (lines.size() == 1 ? label : 0.0);
    const bool fits = letter * svg::text_width(longer) <= room;
    if (fits || (lines.back().empty() && lines.size() > 1))
      lines.back() = longer;
    else
      lines.push_back(word);
  }
  return lines;
}

std::string caption_svg(const std::string& label, const std::vector<std::string>& lines, double top) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string before =
        i == 0 ? fmt::format("<tspan font-weight=\"bold\">{}</tspan> ", svg::markup_escaped(label)) : "";
    text += fmt::format("<text x=\"{}\" y=\"{}\">{}{}</text>\n", margin,
                        svg::svg_number(top + line_height * static_cast<double>(i)), before,
                        svg::markup_escaped(lines[i]));
  }
  return fmt::format("<g font-size=\"{}\" fill=\"#111\">\n{}</g>\n", letter, text);
}

/// Returns the picture as a nested element of another one, at its position.
std::string nested(const std::string& svg, double x) {
  const std::size_t start = std::min(svg.find("<svg"), svg.size());
  if (start == svg.size()) return {};
  return fmt::format("<svg x=\"{}\" y=\"{}\" {}", svg::svg_number(x), margin, svg.substr(start + 4));
}

}  // namespace

std::string printed_page(const GalleryEntry& entry, const GalleryPicture& picture, const std::string& svg) {
  const double inner = std::max(narrowest, picture.width), width = inner + 2.0 * margin;
  const std::string label = label_of(entry, picture);
  const double behind = letter * bold * svg::text_width(label + " ");
  const auto lines = lines_of(words_of(entry, picture), behind, std::min(inner, widest_text));
  const double top = margin + picture.height + margin;
  const double height = top + line_height * static_cast<double>(lines.size());
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"{0}\" "
      "height=\"{1}\" viewBox=\"0 0 {0} {1}\" font-family=\"Helvetica, Arial, sans-serif\">\n<rect "
      "width=\"100%\" "
      "height=\"100%\" fill=\"#fff\"/>\n{2}{3}</svg>\n",
      svg::svg_number(width), svg::svg_number(height), nested(svg, margin + 0.5 * (inner - picture.width)),
      caption_svg(label, lines, top));
}

std::string printed_name(const GalleryEntry& entry) {
  return entry.label.empty() ? entry.title : entry.label + ": " + entry.title;
}

}  // namespace stepwire::gallery
