#include "engine/view/svg/svg.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "engine/base/text/characters.hpp"

namespace stepwire::svg {
namespace {

std::string attribute_text(const SvgAttribute& attribute) {
  if (attribute.value.empty()) return {};
  return fmt::format(" {}=\"{}\"", attribute.name, markup_escaped(attribute.value));
}

/// Returns an element around its inner text.
std::string wrapped(const SvgElement& element, const std::string& inner) {
  std::string text = "<" + element.name;
  for (const SvgAttribute& attribute : element.attributes) text += attribute_text(attribute);
  if (inner.empty()) return text + "/>\n";
  return text + (element.text.empty() ? ">\n" : ">") + inner + "</" + element.name + ">\n";
}

/// One element in all frames.
using Frames = std::vector<const SvgElement*>;

void check_alike(const Frames& frames) {
  const SvgElement& first = *frames.front();
  for (const SvgElement* frame : frames) {
    bool alike = frame->name == first.name && frame->text == first.text &&
                 frame->children.size() == first.children.size() &&
                 frame->attributes.size() == first.attributes.size();
    for (std::size_t i = 0; alike && i < first.attributes.size(); ++i)
      alike = frame->attributes[i].name == first.attributes[i].name;
    if (!alike) throw std::invalid_argument("frames of an animation differ in more than values");
  }
}

/// Returns values at equal distances in time.
std::string smooth_values(const Frames& frames, std::size_t attribute) {
  std::string values;
  for (const SvgElement* frame : frames)
    values += (values.empty() ? "" : ";") + frame->attributes[attribute].value;
  return fmt::format(" values=\"{}\"", markup_escaped(values));
}

/// Returns values that jump, each with the time of its jump as a share of the duration.
std::string jumping_values(const Frames& frames, std::size_t attribute) {
  std::string values, times;
  const std::string* last = nullptr;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::string& value = frames[i]->attributes[attribute].value;
    if (last && *last == value) continue;
    const double share = static_cast<double>(i) / static_cast<double>(frames.size() - 1);
    values += (last ? ";" : "") + value;
    times += (last ? ";" : "") + fmt::format("{:.6g}", share);
    last = &value;
  }
  return fmt::format(" calcMode=\"discrete\" keyTimes=\"{}\" values=\"{}\"", times, markup_escaped(values));
}

std::string animation_of(const Frames& frames, std::size_t attribute, double seconds) {
  const SvgAttribute& first = frames.front()->attributes[attribute];
  bool changes = false;
  for (const SvgElement* frame : frames)
    changes = changes || frame->attributes[attribute].value != first.value;
  if (!changes) return {};
  return fmt::format("<animate attributeName=\"{}\" dur=\"{:.6g}s\" repeatCount=\"indefinite\"{}/>\n",
                     first.name, seconds,
                     first.smooth ? smooth_values(frames, attribute) : jumping_values(frames, attribute));
}

std::string animated(const Frames& frames, double seconds) {
  check_alike(frames);
  const SvgElement& first = *frames.front();
  std::string inner = markup_escaped(first.text);
  for (std::size_t i = 0; i < first.attributes.size(); ++i) inner += animation_of(frames, i, seconds);
  for (std::size_t i = 0; i < first.children.size(); ++i) {
    Frames children;
    for (const SvgElement* frame : frames) children.push_back(&frame->children[i]);
    inner += animated(children, seconds);
  }
  return wrapped(first, inner);
}

/// From blank to tilde, in thousandths of the font size.
constexpr std::array<short, 95> widths{
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838};
/// Other letters: European ones, and wide signs from the dashes on.
constexpr short european = 800, wide = 1000;

}  // namespace

std::string markup_escaped(const std::string& text) {
  std::string result;
  for (const char c : text::printable(text)) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

std::string svg_number(double value) {
  constexpr double digits = 100.0;
  return fmt::format("{}", std::round(value * digits) / digits + 0.0);  // avoids -0
}

SvgElement& SvgElement::set(std::string attribute, std::string value) {
  attributes.push_back({std::move(attribute), std::move(value)});
  return *this;
}

SvgElement& SvgElement::set(std::string attribute, double value) {
  return set(std::move(attribute), svg_number(value));
}

SvgElement& SvgElement::move(std::string attribute, double value) {
  attributes.push_back({std::move(attribute), svg_number(value), true});
  return *this;
}

SvgElement& SvgElement::add(SvgElement child) {
  children.push_back(std::move(child));
  return *this;
}

std::string svg_text(const SvgElement& element) {
  std::string inner = markup_escaped(element.text);
  for (const SvgElement& child : element.children) inner += svg_text(child);
  return wrapped(element, inner);
}

std::string animated_svg(const std::vector<SvgElement>& frames, double seconds) {
  if (frames.size() < 2) throw std::invalid_argument("an animation has two frames at least");
  Frames all;
  for (const SvgElement& frame : frames) all.push_back(&frame);
  return animated(all, seconds);
}

double text_width(std::string_view text) {
  int sum = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) sum += widths[byte - 0x20u];
    if (byte >= 0xc0) sum += byte < 0xe2 ? european : wide;  // first byte of a UTF-8 letter
  }
  return sum / 1000.0;
}

double fitted_size(std::string_view text, double wanted, double room) {
  const double width = text_width(text);
  return width * wanted > room ? room / width : wanted;
}

}  // namespace stepwire::svg
