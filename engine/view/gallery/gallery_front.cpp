#include "engine/view/gallery/gallery_front.hpp"

#include <algorithm>

#include "engine/view/gallery/gallery_findings.hpp"
#include "engine/view/gallery/gallery_html.hpp"
#include "engine/view/gallery/gallery_tally.hpp"

namespace stepwire::gallery {
namespace {

/// Returns the first picture of an entry that the source has too.
const GalleryPicture* thumbnail_of(const GalleryEntry& entry) {
  const auto shown = std::ranges::find(entry.pictures, false, &GalleryPicture::own);
  if (shown != entry.pictures.end()) return &*shown;
  return entry.pictures.empty() ? nullptr : &entry.pictures.front();
}

/// Returns the part of a picture that a card shows: the beginning of a wide one, the upper left part of a
/// block diagram. All of either would be illegible.
const char* part_of(const GalleryPicture& picture) {
  constexpr double band = 3.5;
  if (picture.width > band * picture.height) return " wide";
  return picture.dense ? " dense" : "";
}

Html thumbnail(const GalleryEntry& entry) {
  const GalleryPicture* picture = thumbnail_of(entry);
  if (!picture) return html("<span class=\"thumb\"></span>");
  return html(
      "<span class=\"thumb{}{}\"><img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"\" "
      "loading=\"lazy\"></span>",
      picture->dark ? "" : " plain", part_of(*picture), Address{entry.folder + "/" + picture->file},
      static_cast<std::size_t>(picture->width), static_cast<std::size_t>(picture->height));
}

/// Returns the words for searches, in addition to those on the card.
std::string words_of(const GalleryEntry& entry) {
  std::string words = "section " + entry.section + " " + entry.folder + " " + entry.caption + " " +
                      entry.source_caption + " " + entry.source_says;
  for (const claim::Verdict& verdict : entry.verdicts)
    if (verdict.kind == claim::Claim::Kind::statement) words += " " + verdict.that + " " + verdict.disagrees;
  for (const std::string& departure : entry.departures) words += " " + departure;
  return words;
}

/// Returns the properties by which cards are filtered.
std::string traits_of(const GalleryEntry& entry) {
  std::string traits = entry.table ? "table" : "figure";
  if (entry.table && entry.figure) traits += " figure";
  if (tally_of(entry).known > 0) traits += " disagrees";
  if (tally_of(entry).bad()) traits += " fails";
  if (!entry.departures.empty()) traits += " departures";
  return traits;
}

Html card(const GalleryEntry& entry) {
  const ClaimTally tally = tally_of(entry);
  const std::string claims = tally.errors > 0 ? "did not run"
                             : tally.all == 0 ? ""
                             : tally.known == 0
                                 ? fmt::format("{} hold", tally.hold)
                                 : fmt::format("{} hold, {} known not to", tally.hold, tally.known);
  return html(R"(<li class="card {}" data-traits="{}" data-words="{}"><a href="{}">{}
<span class="label">{}</span> <span class="title">{}</span> <span class="verdict">{}</span></a></li>
)",
              tally.look(), traits_of(entry), words_of(entry), Address{page_of(entry)}, thumbnail(entry),
              short_name(entry), entry.label.empty() ? "" : entry.title, claims);
}

Html summary_of(const Gallery& gallery, const std::string& chapter) {
  Html all;
  for (const ChapterSummary& summary : gallery.summaries) {
    if (summary.chapter != chapter) continue;
    for (const std::string& sentence : summary.sentences) all += html("<p>{}</p>\n", sentence);
    all = html("<div class=\"chapter-summary\">\n<h4>{}</h4>\n{}</div>\n", summary.title, all);
  }
  return all;
}

Html chapter(const Gallery& gallery, const GalleryEntry& entry, const Html& cards) {
  const std::string number = chapter_of(entry);
  const Html print = entry.print.file.empty()
                         ? Html{}
                         : html("\n<p class=\"soft\"><a href=\"{}\">Its figures with captions as PDF</a></p>",
                                Address{entry.print.file});
  return html(
      "<section class=\"chapter\">\n<div class=\"head\"><h3>{}</h3>{}</div>\n{}<ul "
      "class=\"cards\">\n{}</ul>\n</section>\n",
      number.empty() ? "Beside the chapters" : "Chapter " + number, print, summary_of(gallery, number),
      cards);
}

Html thumbnails(const Gallery& gallery) {
  Html chapters, cards;
  for (std::size_t i = 0; i < gallery.entries.size(); ++i) {
    const GalleryEntry& entry = gallery.entries[i];
    cards += card(entry);
    const bool last =
        i + 1 == gallery.entries.size() || chapter_of(gallery.entries[i + 1]) != chapter_of(entry);
    if (!last) continue;
    chapters += chapter(gallery, entry, cards);
    cards = {};
  }
  if (chapters.empty()) return {};
  return html(
      "<section id=\"figures\">\n<h2>Figures and tables</h2>\n<div id=\"search\"></div>\n{}</section>\n",
      chapters);
}

}  // namespace

std::string gallery_front(const Gallery& gallery) {
  const ClaimTally tally = tally_of(gallery.entries);
  Html head = html("<header>\n<h1>{}</h1>\n", gallery.title);
  if (!gallery.introduction.empty()) head += html("<p class=\"lead\">{}</p>\n", gallery.introduction);
  head += html("<p class=\"summary {}\">{}</p>\n</header>\n", tally.bad() ? "bad" : "good", tally.sentence());
  const GalleryFrame frame{.page = "index.html", .title = gallery.title, .look = "front"};
  return framed(frame, html("{}{}{}", head, gallery_findings(gallery), thumbnails(gallery)));
}

}  // namespace stepwire::gallery
