#include "engine/view/gallery/gallery_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "engine/base/json/json.hpp"
#include "engine/base/mat/deflate.hpp"
#include "engine/base/text/base64.hpp"
#include "engine/view/plot/plot_kind.hpp"
#include "engine/view/svg/svg.hpp"

namespace stepwire::gallery {
namespace {

constexpr double page_width = 1400.0, page_height = 820.0;  // of a screen [px]
constexpr double max_scale = 1.5;  // larger letters are too large to read comfortably

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

/// Returns the largest scale that a page and a screen permit, at least 1.
double scale_of(const GalleryPicture& picture) {
  const double widest = page_width / std::max(1.0, picture.width);
  const double fitting = std::min({widest, page_height / std::max(1.0, picture.height), max_scale});
  return std::max(fitting, std::min(1.0, widest));
}

std::size_t pixels(double value) {
  return static_cast<std::size_t>(std::lround(value));
}

Html image_of(const GalleryPicture& picture) {
  const double scale = scale_of(picture);
  return html("<img{} src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\" style=\"--wide: {}px\">",
              html(picture.dark ? "" : " class=\"plain\""), Address{picture.file},
              pixels(scale * picture.width), pixels(scale * picture.height), picture.alt,
              pixels(scale * picture.width));
}

/// Returns the figure. Its enlargement is a state of the page that its address names, so it works without a
/// script.
Html figure_of(const GalleryPicture& picture, std::size_t number) {
  Html words;
  if (!picture.title.empty()) words += html("<strong>{}</strong> ", picture.title);
  words += html("{}", picture.caption);
  if (!picture.caption.empty() || !picture.title.empty())
    words = html("<figcaption>{}</figcaption>\n", words);
  return html(R"(<div class="place-of-picture" id="picture-{0}">
<figure class="picture" id="large-{0}">
<a class="reduce" href="#picture-{0}">Back to the width of the page</a>
<div class="frame">{1}<a class="enlarge" href="#large-{0}"><span>Enlarge picture {0}</span></a></div>
{2}</figure>
</div>
)",
              number, image_of(picture), words);
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

Html pictures_of(const GalleryEntry& entry, bool own) {
  Html pictures;
  for (std::size_t i = 0; i < entry.pictures.size(); ++i)
    if (entry.pictures[i].own == own) pictures += figure_of(entry.pictures[i], i + 1);
  if (!own || pictures.empty()) return pictures;
  return html(
      "<section id=\"own\">\n<h2>Of our own</h2>\n<p class=\"soft\">The thesis has no such "
      "picture.</p>\n{}</section>\n",
      pictures);
}

}  // namespace stepwire::gallery
