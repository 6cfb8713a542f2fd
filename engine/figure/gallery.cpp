#include "engine/figure/gallery.hpp"

#include <fmt/format.h>

#include "engine/figure/gallery_style.hpp"

namespace stepwire {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
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

/// A path as a link: what has a meaning in an address is written as its code.
std::string link_to(const std::string& path) {
  std::string result;
  for (const char c : path) {
    if (c == ' ' || c == '#' || c == '?' || c == '%' || c == '"' || c == '<' || c == '>')
      result += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    else
      result += c;
  }
  return escaped(result);
}

std::string full_title(const GalleryEntry& entry) {
  if (entry.label.empty() || entry.title.empty()) return escaped(entry.label + entry.title);
  return fmt::format("<span class=\"label\">{}</span> {}", escaped(entry.label), escaped(entry.title));
}

std::string anchor(std::size_t index) {
  return fmt::format("entry-{}", index + 1);
}

/// How many claims there are, and how they ended.
struct Tally {
  std::size_t all = 0, hold = 0, known = 0, fail = 0, surprise = 0, errors = 0;

  explicit Tally(const Gallery& gallery) {
    for (const auto& entry : gallery.entries) {
      errors += entry.error.empty() ? 0 : 1;
      for (const auto& verdict : entry.verdicts) count(verdict);
    }
  }
  void count(const Verdict& verdict) {
    ++all;
    if (verdict.surprises())
      ++surprise;
    else if (verdict.holds)
      ++hold;
    else
      ++(verdict.fails() ? fail : known);
  }
};

std::string verdict_class(const Verdict& verdict) {
  if (verdict.surprises() || verdict.fails()) return "bad";
  return verdict.holds ? "good" : "known";
}

std::string summary(const Gallery& gallery) {
  const Tally tally(gallery);
  std::string line = fmt::format("{} of {} claims hold", tally.hold, tally.all);
  if (tally.known > 0) line += fmt::format(", {} known not to hold", tally.known);
  if (tally.fail > 0) line += fmt::format(", {} {} not hold", tally.fail, tally.fail == 1 ? "does" : "do");
  if (tally.surprise > 0)
    line += fmt::format(", {} {} after all", tally.surprise, tally.surprise == 1 ? "holds" : "hold");
  if (tally.errors > 0)
    line += fmt::format(", {} {} not run", tally.errors, tally.errors == 1 ? "file did" : "files did");
  const bool bad = tally.fail + tally.surprise + tally.errors > 0;
  return fmt::format("<p class=\"summary {}\">{}.</p>\n", bad ? "bad" : "good", line);
}

/// What a reader must look at first: every claim that ended otherwise than expected.
std::string failures(const Gallery& gallery) {
  std::string items;
  for (std::size_t i = 0; i < gallery.entries.size(); ++i) {
    const auto& entry = gallery.entries[i];
    const auto add = [&](const std::string& text) {
      items += fmt::format("<li><a href=\"#{}\">{}</a>: {}</li>\n", anchor(i), full_title(entry), text);
    };
    if (!entry.error.empty()) add("did not run");
    for (const auto& verdict : entry.verdicts)
      if (verdict.fails() || verdict.surprises()) add(escaped(verdict.that) + " – " + verdict.word());
  }
  return items.empty() ? "" : "<ul class=\"failures\">\n" + items + "</ul>\n";
}

std::string pictures(const GalleryEntry& entry) {
  std::string html;
  for (const auto& picture : entry.pictures)
    html += fmt::format("<a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\" loading=\"lazy\"></a>\n",
                        link_to(picture), escaped(entry.label + ": " + entry.title));
  return html;
}

std::string claim_row(const Verdict& verdict) {
  std::string html = fmt::format("<li class=\"{}\"><span class=\"verdict\">{}</span> {}",
                                 verdict_class(verdict), verdict.word(), escaped(verdict.that));
  const std::string value = verdict.note.empty() ? verdict.shown : verdict.note;
  html += fmt::format("<br><code>{}</code>", escaped(verdict.check));
  if (!value.empty()) html += fmt::format(" <span class=\"value\">{}</span>", escaped(value));
  if (!verdict.disagrees.empty()) html += fmt::format("<br><em>{}</em>", escaped(verdict.disagrees));
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
    html += fmt::format("<tr><td><code>{}</code></td><td>{}</td><td>{}</td></tr>\n", escaped(assumption.name),
                        escaped(assumption.value), escaped(assumption.doc));
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
  std::string html = fmt::format("<article id=\"{}\">\n<h2>{}</h2>\n", anchor(index), full_title(entry));
  if (!entry.error.empty()) html += "<pre class=\"error\">" + escaped(entry.error) + "</pre>\n";
  html += pictures(entry);
  if (!entry.caption.empty()) html += "<p>" + escaped(entry.caption) + "</p>\n";
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
      escaped(gallery.title), gallery_style);
  if (!gallery.introduction.empty()) html += "<p>" + escaped(gallery.introduction) + "</p>\n";
  html += summary(gallery) + failures(gallery) + "</header>\n<main>\n";
  for (std::size_t i = 0; i < gallery.entries.size(); ++i) html += card(gallery.entries[i], i);
  return html + "</main>\n</body>\n</html>\n";
}

}  // namespace stepwire
