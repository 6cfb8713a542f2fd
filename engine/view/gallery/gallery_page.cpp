#include "engine/view/gallery/gallery_page.hpp"

#include <filesystem>
#include <string_view>

#include "engine/view/gallery/gallery_assets.hpp"
#include "engine/view/svg/svg.hpp"

namespace stepwire::gallery {

std::string html_piece(const Html& html) {
  return html.code;
}

std::string html_piece(const std::string& text) {
  return svg::markup_escaped(text);
}

std::string html_piece(const Address& address) {
  std::string result;
  for (const char c : address.path) {
    if (std::string_view(" #?%\"<>").find(c) != std::string_view::npos)
      result += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    else
      result += c;
  }
  return svg::markup_escaped(result);
}

std::string counted(std::size_t count, const std::string& one, const std::string& several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

Address address_from(const std::string& page, const std::string& target) {
  namespace fs = std::filesystem;
  return {fs::path(target).lexically_relative(fs::path(page).parent_path()).generic_string()};
}

/// Returns the elements of the head for the style of a page and its script, which a contained page does
/// without.
static Html look_and_script(const GalleryFrame& frame) {
  if (frame.contained)
    return {fmt::format("<style>\n{}td, th {{ overflow-wrap: break-word; }}\n</style>\n", gallery_style)};
  return html("<link rel=\"stylesheet\" href=\"{}\">\n<script src=\"{}\" defer></script>\n",
              address_from(frame.page, "gallery.css"), address_from(frame.page, "gallery.js"));
}

std::string framed(const GalleryFrame& frame, const Html& content) {
  const Html head = html(R"(<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>{}</title>
<link rel="icon" href="data:,">
{}{})",
                         frame.title, look_and_script(frame), frame.links);
  return html(R"(<!DOCTYPE html>
<html lang="en">
<head>
{}</head>
<body class="{}">
<a class="skip" href="#content">To the content</a>
{}<main id="content" tabindex="-1">
{}</main>
</body>
</html>
)",
              head, frame.look, frame.navigation, content)
      .code;
}

void ClaimTally::count(const GalleryEntry& entry) {
  errors += entry.error.empty() ? 0 : 1;
  for (const claim::Verdict& verdict : entry.verdicts) count(verdict);
}

void ClaimTally::count(const claim::Verdict& verdict) {
  if (verdict.kind == claim::Claim::Kind::invariant) {
    ++(verdict.holds ? invariants : broken);
    return;
  }
  ++all;
  if (verdict.surprises())
    ++surprise;
  else if (verdict.holds)
    ++hold;
  else
    ++(verdict.fails() ? fail : known);
}

std::string ClaimTally::sentence() const {
  std::string line = counted(hold, "claim holds", "claims hold");
  if (known > 0) line += fmt::format(", {} known not to", known);
  if (fail > 0) line += ", " + counted(fail, "does not hold", "do not hold");
  if (surprise > 0) line += ", " + counted(surprise, "holds after all", "hold after all");
  if (invariants > 0) line += ", " + counted(invariants, "invariant", "invariants") + " held throughout";
  if (broken > 0) line += ", " + counted(broken, "invariant is broken", "invariants are broken");
  if (errors > 0) line += ", " + counted(errors, "file did not run", "files did not run");
  return line + ".";
}

ClaimTally tally_of(const GalleryEntry& entry) {
  ClaimTally tally;
  tally.count(entry);
  return tally;
}

ClaimTally tally_of(const std::vector<GalleryEntry>& entries) {
  ClaimTally tally;
  for (const GalleryEntry& entry : entries) tally.count(entry);
  return tally;
}

std::string gallery_verdict(const std::vector<GalleryEntry>& entries) {
  return tally_of(entries).sentence();
}

std::string look_of(const claim::Verdict& verdict) {
  if (verdict.surprises() || verdict.fails()) return "bad";
  return verdict.holds ? "good" : "known";
}

std::string short_name(const GalleryEntry& entry) {
  return entry.label.empty() ? entry.title : entry.label;
}

std::string full_name(const GalleryEntry& entry) {
  return entry.label.empty() || entry.title.empty() ? entry.label + entry.title
                                                    : entry.label + ": " + entry.title;
}

std::string chapter_of(const GalleryEntry& entry) {
  return entry.section.substr(0, entry.section.find('.'));
}

std::string page_of(const GalleryEntry& entry) {
  return entry.folder + "/index.html";
}

}  // namespace stepwire::gallery
