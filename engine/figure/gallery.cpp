#include "engine/figure/gallery.hpp"

#include <fmt/format.h>

#include "engine/figure/gallery_front.hpp"
#include "engine/figure/gallery_style.hpp"
#include "engine/figure/svg.hpp"

namespace stepwire {
namespace {

/// A path as a link: what has a meaning in an address is written as its code.
std::string link_to(const std::string& path) {
  std::string result;
  for (const char c : path) {
    if (c == ' ' || c == '#' || c == '?' || c == '%' || c == '"' || c == '<' || c == '>')
      result += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    else
      result += c;
  }
  return markup_escaped(result);
}

std::string verdict_class(const Verdict& verdict) {
  if (verdict.surprises() || verdict.fails()) return "bad";
  return verdict.holds ? "good" : "known";
}

std::string pictures(const GalleryEntry& entry) {
  std::string html;
  for (const auto& picture : entry.pictures)
    html += fmt::format("<a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\" loading=\"lazy\"></a>\n",
                        link_to(picture), markup_escaped(entry.label + ": " + entry.title));
  return html;
}

std::string claim_row(const Verdict& verdict) {
  std::string html = fmt::format("<li class=\"{}\"><span class=\"verdict\">{}</span> {}",
                                 verdict_class(verdict), verdict.word(), markup_escaped(verdict.that));
  const std::string value = verdict.note.empty() ? verdict.shown : verdict.note;
  html += fmt::format("<br><code>{}</code>", markup_escaped(verdict.check));
  if (!value.empty()) html += fmt::format(" <span class=\"value\">{}</span>", markup_escaped(value));
  if (!verdict.disagrees.empty()) html += fmt::format("<br><em>{}</em>", markup_escaped(verdict.disagrees));
  return html + "</li>\n";
}

std::string claims(const GalleryEntry& entry) {
  if (entry.verdicts.empty()) return {};
  std::string html = "<h3>Claims</h3>\n<ul class=\"claims\">\n";
  for (const auto& verdict : entry.verdicts) html += claim_row(verdict);
  return html + "</ul>\n";
}

std::string assumptions(const GalleryEntry& entry) {
  if (entry.assumptions.empty()) return {};
  std::string html =
      fmt::format("<details>\n<summary>{} assumed {}</summary>\n<table>\n", entry.assumptions.size(),
                  entry.assumptions.size() == 1 ? "value" : "values");
  html +=
      "<tr><th scope=\"col\">Parameter</th><th scope=\"col\">Value</th><th scope=\"col\">Meaning</th></tr>\n";
  for (const auto& assumption : entry.assumptions)
    html += fmt::format("<tr><td><code>{}</code></td><td>{}</td><td>{}</td></tr>\n",
                        markup_escaped(assumption.name), markup_escaped(assumption.value),
                        markup_escaped(assumption.doc));
  return html + "</table>\n</details>\n";
}

std::string links(const GalleryEntry& entry) {
  std::string html;
  if (!entry.diagram.empty()) html += fmt::format("<a href=\"{}\">Diagram file</a>", link_to(entry.diagram));
  if (!entry.folder.empty())
    html += fmt::format("{}<a href=\"{}\">All files of the run</a>", html.empty() ? "" : " · ",
                        link_to(entry.folder));
  return html.empty() ? "" : "<p class=\"links\">" + html + "</p>\n";
}

std::string card(const GalleryEntry& entry, std::size_t index) {
  std::string html =
      fmt::format("<article id=\"{}\">\n<h2>{}</h2>\n", gallery_anchor(index), gallery_title(entry));
  if (!entry.error.empty()) html += "<pre class=\"error\">" + markup_escaped(entry.error) + "</pre>\n";
  html += pictures(entry);
  if (!entry.caption.empty()) html += "<p>" + markup_escaped(entry.caption) + "</p>\n";
  return html + claims(entry) + assumptions(entry) + links(entry) + "</article>\n";
}

}  // namespace

std::string gallery_page(const Gallery& gallery) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light "
      "dark\">\n<title>{0}</title>\n<style>\n{1}</style>\n</head>\n"
      "<body>\n<header>\n<h1>{0}</h1>\n",
      markup_escaped(gallery.title), gallery_style);
  if (!gallery.introduction.empty()) html += "<p>" + markup_escaped(gallery.introduction) + "</p>\n";
  html += gallery_front(gallery) + "</header>\n<main>\n";
  for (std::size_t i = 0; i < gallery.entries.size(); ++i) html += card(gallery.entries[i], i);
  return html + "</main>\n</body>\n</html>\n";
}

}  // namespace stepwire
