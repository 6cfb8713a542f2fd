#include "engine/view/gallery/gallery.hpp"

#include <algorithm>
#include <tuple>

#include "engine/view/gallery/gallery_assets.hpp"
#include "engine/view/gallery/gallery_page.hpp"

namespace stepwire::gallery {
namespace {

Html link_to(const GalleryEntry& entry, const std::string& text) {
  return html("<a href=\"{}\">{}</a>", Address{page_of(entry)}, text);
}

Html unexpected(const Gallery& gallery) {
  Html items;
  for (const GalleryEntry& entry : gallery.entries) {
    if (!entry.error.empty()) items += html("<li>{}: did not run</li>\n", link_to(entry, full_name(entry)));
    for (const claim::Verdict& verdict : entry.verdicts)
      if (verdict.fails() || verdict.surprises())
        items +=
            html("<li>{}: {} – {}</li>\n", link_to(entry, full_name(entry)), verdict.that, verdict.word());
  }
  if (items.empty()) return {};
  return html(
      "<section id=\"unexpected\">\n<h2>What ends otherwise than expected</h2>\n<ul>\n{}</ul>\n</section>\n",
      items);
}

/// Returns a finding that is collapsed initially.
Html folded(const std::string& id, const std::string& title, const std::string& count, const Html& content) {
  return html(
      "<details class=\"finding\" id=\"{}\">\n<summary><h2>{}</h2> <span "
      "class=\"count\">{}</span></summary>\n{}</details>\n",
      id, title, count, content);
}

/// List of items for each entry that has some.
class EntryList {
 public:
  void add(const GalleryEntry& entry, const Html& items, std::size_t count) {
    if (count == 0) return;
    list_ += html("<dt>{}</dt>\n<dd><ul>\n{}</ul></dd>\n", link_to(entry, full_name(entry)), items);
    count_ += count;
  }
  std::size_t count() const { return count_; }
  Html list() const { return html("<dl class=\"by-entry\">\n{}</dl>\n", list_); }

 private:
  Html list_;
  std::size_t count_ = 0;
};

Html disagreements(const Gallery& gallery) {
  EntryList list;
  for (const GalleryEntry& entry : gallery.entries) {
    Html items;
    std::size_t count = 0;
    for (const claim::Verdict& verdict : entry.verdicts) {
      if (verdict.disagrees.empty() || verdict.holds) continue;
      items += html("<li>{}<br><em>{}</em></li>\n", verdict.that, verdict.disagrees);
      ++count;
    }
    list.add(entry, items, count);
  }
  if (list.count() == 0) return {};
  return folded("disagrees", "What disagrees with the text", counted(list.count(), "statement", "statements"),
                list.list());
}

Html departures(const Gallery& gallery) {
  EntryList list;
  for (const GalleryEntry& entry : gallery.entries) {
    Html items;
    for (const std::string& departure : entry.departures) items += html("<li>{}</li>\n", departure);
    list.add(entry, items, entry.departures.size());
  }
  if (list.count() == 0) return {};
  return folded("departures", "Departures from the text", counted(list.count(), "departure", "departures"),
                list.list());
}

/// Links to several entries: "Figure 24, 25, Table 2, Figure 27".
class EntryLinks {
 public:
  void add(const GalleryEntry& entry) {
    if (last_ == &entry) return;
    const std::string figure = "Figure ";
    const bool again = last_ && last_->label.starts_with(figure) && entry.label.starts_with(figure);
    if (last_) links_ += html(", ");
    links_ += link_to(entry, again ? entry.label.substr(figure.size()) : short_name(entry));
    last_ = &entry;
  }
  const Html& links() const { return links_; }

 private:
  Html links_;
  const GalleryEntry* last_ = nullptr;
};

/// Returns the assumptions. Values that entries share are listed once, in the order of their first
/// appearance.
Html assumed(const Gallery& gallery) {
  using Key = std::tuple<std::string, std::string, std::string>;
  std::vector<Key> order;
  std::map<Key, EntryLinks> links;
  for (const GalleryEntry& entry : gallery.entries)
    for (const Assumption& one : entry.assumptions) {
      const Key key{one.name.substr(one.name.rfind('.') + 1), one.value, one.doc};
      if (!links.contains(key)) order.push_back(key);
      links[key].add(entry);
    }
  if (order.empty()) return {};
  Html rows;
  for (const Key& key : order)
    rows += html("<tr><td><code>{}</code></td><td>{}</td><td>{}</td><td>{}</td></tr>\n", std::get<0>(key),
                 std::get<1>(key), std::get<2>(key), links[key].links());
  return folded("assumed", "What is assumed", counted(order.size(), "value", "values"),
                html("<table class=\"assumed\">\n<thead><tr><th scope=\"col\">Parameter</th><th "
                     "scope=\"col\">Value</th><th "
                     "scope=\"col\">Meaning</th><th "
                     "scope=\"col\">Where</th></tr></thead>\n<tbody>\n{}</tbody></table>\n",
                     rows));
}

/// Returns the findings over all entries: unexpected results, disagreements with the source, departures from
/// it and assumptions, each with links to the entries.
Html gallery_findings(const Gallery& gallery) {
  const Html findings = html("{}{}{}", disagreements(gallery), departures(gallery), assumed(gallery));
  if (findings.empty()) return unexpected(gallery);
  return html("{}<div class=\"findings\">\n{}</div>\n", unexpected(gallery), findings);
}

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

/// Returns the front page. It contains the count of claims that hold, summaries of chapters, unexpected
/// results, disagreements, departures, assumptions, and a thumbnail of each entry by chapter.
std::string gallery_front(const Gallery& gallery) {
  const ClaimTally tally = tally_of(gallery.entries);
  Html head = html("<header>\n<h1>{}</h1>\n", gallery.title);
  if (!gallery.introduction.empty()) head += html("<p class=\"lead\">{}</p>\n", gallery.introduction);
  head += html("<p class=\"summary {}\">{}</p>\n</header>\n", tally.bad() ? "bad" : "good", tally.sentence());
  const GalleryFrame frame{.page = "index.html", .title = gallery.title, .look = "front"};
  return framed(frame, html("{}{}{}", head, gallery_findings(gallery), thumbnails(gallery)));
}

}  // namespace

std::map<std::string, std::string> gallery_files(const Gallery& gallery) {
  const GallerySources sources = sources_of(gallery);
  std::map<std::string, std::string> files{
      {"index.html", gallery_front(gallery)}, {"gallery.css", gallery_style}, {"gallery.js", gallery_script}};
  for (std::size_t i = 0; i < gallery.entries.size(); ++i)
    files[page_of(gallery.entries[i])] = entry_page(gallery, sources, i);
  for (const auto& [path, text] : sources) {
    files[path] = text;
    files[page_of_source(path)] = source_page(gallery, sources, path);
  }
  return files;
}

}  // namespace stepwire::gallery
