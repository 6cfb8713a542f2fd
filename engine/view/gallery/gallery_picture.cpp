#include "engine/view/gallery/gallery_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <utility>
#include <vector>

#include "engine/base/json/json.hpp"
#include "engine/base/mat/deflate.hpp"
#include "engine/base/text/base64.hpp"
#include "engine/view/plot/plot_kind.hpp"
#include "engine/view/svg/svg.hpp"

namespace stepwire::gallery {
namespace {

/// Returns "force [N], current [A]", each once; the label of the axis if it has one.
std::string labels_of(const plot::Panel& panel, const std::string& key) {
  const auto found = panel.series.find(key);
  if (found == panel.series.end()) return {};
  std::vector<std::string> labels;
  for (query::Series series : found->second) {
    if (const std::string& label = panel.axis(key).label; !label.empty()) series.label = label;
    if (std::ranges::find(labels, series.axis_label()) == labels.end()) labels.push_back(series.axis_label());
  }
  return fmt::format("{}", fmt::join(labels, ", "));
}

/// Returns the last of the channels color, z, y and x that the panel has, and its independent axes.
std::string axes_of(const plot::Panel& panel) {
  std::vector<std::string> axes;
  for (const char* key : {"x", "y", "z", "color"})
    if (const std::string labels = labels_of(panel, key); !labels.empty()) axes.push_back(labels);
  if (axes.empty()) return {};
  const std::string shown = axes.back();
  axes.pop_back();
  return shown + (axes.empty() ? "" : " over ") + fmt::format("{}", fmt::join(axes, " and "));
}

/// Returns the description of a kind of plot without axes.
std::string kind_in_words(const std::string& kind) {
  static const std::map<std::string, std::string> words{{"diagram", "the diagram as blocks and wires"},
                                                        {"rig", "the mechanism"},
                                                        {"scene", "what is on the screen"},
                                                        {"table", "a table of results"}};
  const auto found = words.find(kind);
  return found == words.end() ? kind : found->second;
}

std::string described(const plot::Panel& panel) {
  const std::string axes = axes_of(panel);
  std::string text = panel.title;
  if (!axes.empty()) text += (text.empty() ? "" : ", ") + axes;
  return text.empty() ? kind_in_words(panel.kind->name) : text;
}

/// Returns the first title in a picture, which screen readers use.
std::string title_of(const std::string& svg) {
  const std::size_t start = svg.find("<title>"), end = svg.find("</title>");
  if (start == std::string::npos || end == std::string::npos) return {};
  std::string title = svg.substr(start + 7, end - start - 7);
  for (const auto& [code, sign] : {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}})
    text::replace_all(title, code, sign);
  return title;
}

/// Returns an attribute of the first element svg as a number; 0 if it is missing.
double attribute_of(const std::string& svg, const std::string& name) {
  const std::size_t start = std::min(svg.find("<svg"), svg.size());
  const std::string element = svg.substr(start, svg.find('>', start) - start);
  const std::size_t at = element.find(" " + name + "=\"");
  return at == std::string::npos ? 0.0 : std::strtod(element.c_str() + at + name.size() + 3, nullptr);
}

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

std::string described(const plot::Figure& figure) {
  std::vector<std::string> panels;
  for (const plot::Panel& panel : figure.panels) panels.push_back(described(panel));
  const std::string text = fmt::format("{}", fmt::join(panels, "; "));
  return figure.title.empty() ? text : figure.title + ": " + text;
}

void read_picture(GalleryPicture& picture, const std::string& svg) {
  picture.width = attribute_of(svg, "width");
  picture.height = attribute_of(svg, "height");
  const std::string title = title_of(svg);
  if (picture.alt.find(title) == std::string::npos) picture.alt = title + ": " + picture.alt;
  const bool white = svg.find("fill=\"#fff") != std::string::npos;
  picture.dark = !white || svg.find("prefers-color-scheme") != std::string::npos;
}

std::string picture_script(const std::map<std::string, std::string>& pictures) {
  json::Json texts = json::Json::object();
  for (const auto& [name, svg] : pictures) texts.set(name, svg);
  return "stepwirePictures(\"" + text::base64(mat::gzip_packed(texts.text(-1))) + "\");\n";
}

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
