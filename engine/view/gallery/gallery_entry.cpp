#include "engine/view/gallery/gallery_page.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace stepwire::gallery {
namespace {

constexpr double page_width = 1400.0, page_height = 820.0;  // of a screen [px]
constexpr double max_scale = 1.5;  // larger letters are too large to read comfortably

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

/// Returns the pictures of an entry that the source has, or with `own` a section of those that it does not
/// have.
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

/// Files with an extension, also with .gz appended, and their name.
struct DownloadKind {
  const char* ending;
  const char* name;

  bool has(const std::string& file) const {
    return file.ends_with(ending) || file.ends_with(std::string(ending) + ".gz");
  }
};

constexpr std::array<DownloadKind, 5> download_kinds{{{".svg", "Pictures, SVG"},
                                                      {".csv", "Data, CSV"},
                                                      {".mat", "Data, MAT"},
                                                      {".txt", "Tables"},
                                                      {".json", "Of the run"}}};

std::string size_text(std::uintmax_t bytes) {
  if (bytes < 1000) return fmt::format("{} B", bytes);
  if (bytes < 1000000) return fmt::format("{} kB", (bytes + 500) / 1000);
  return fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

Html download(const std::string& page, const std::string& path, std::uintmax_t bytes) {
  return html("<a href=\"{}\" download>{}</a> <span class=\"soft\">{}</span>", address_from(page, path),
              std::filesystem::path(path).filename().string(), size_text(bytes));
}

/// Returns the link to a file; a file of another entry is labelled with that entry.
Html download(const GalleryEntry& entry, const GalleryDownload& file) {
  if (file.folder.empty()) return download(page_of(entry), entry.folder + "/" + file.file, file.bytes);
  return html("{}<span class=\"soft\">, the same as of {}</span>",
              download(page_of(entry), file.folder + "/" + file.file, file.bytes), file.label);
}

Html downloads_of_kind(const GalleryEntry& entry, const DownloadKind& kind) {
  Html links;
  for (const GalleryDownload& file : entry.downloads)
    if (kind.has(file.file)) links += html("{}{}", html(links.empty() ? "" : "<br>"), download(entry, file));
  return links.empty() ? links : html("<dt>{}</dt>\n<dd>{}</dd>\n", kind.name, links);
}

/// Returns the link to the pages of this entry in a file with more pictures.
Html print_of(const GalleryEntry& entry) {
  if (entry.print.file.empty() || entry.pictures.empty()) return {};
  const std::size_t first = entry.print.page, last = first + entry.pictures.size() - 1;
  Address address = address_from(page_of(entry), entry.print.file);
  const Html pages = first == last ? html("page {}", first) : html("pages {} to {}", first, last);
  return html(
      "<dt>Pictures, PDF</dt>\n<dd><a href=\"{}#page={}\">{}</a> <span class=\"soft\">{}</span></dd>\n",
      address, first, entry.print.file, pages);
}

Html parts_of(const GalleryEntry& entry) {
  Html links;
  for (const GallerySource& source : entry.sources) {
    if (&source == &entry.sources.front()) continue;
    links += html("{}<a href=\"{}\">{}</a>", links.empty() ? "" : " · ",
                  address_from(page_of(entry), page_of_source(source.path)),
                  std::filesystem::path(source.path).stem().string());
  }
  return links.empty() ? links : html("<p>Parts that it uses: {}</p>\n", links);
}

/// Returns the downloads of an entry, sorted by kind.
Html downloads_of(const GalleryEntry& entry) {
  Html list;
  for (const DownloadKind& kind : download_kinds) list += downloads_of_kind(entry, kind);
  list += print_of(entry);
  if (!entry.sources.empty())
    list += html("<dt>Diagram</dt>\n<dd>{}</dd>\n",
                 download(page_of(entry), entry.sources.front().path, entry.sources.front().text.size()));
  if (list.empty()) return {};
  const Html note = entry.note.empty() ? Html{} : html("<p class=\"soft\">{}</p>\n", entry.note);
  return html(
      "<section id=\"downloads\">\n<h2>To take along</h2>\n<dl class=\"downloads\">\n{}</dl>\n{}</section>\n",
      list, note);
}

/// Returns the diagram file of an entry with syntax colours and links to its parts.
Html diagram_of(const GalleryEntry& entry, const GallerySources& sources) {
  if (entry.sources.empty()) return {};
  return html("<section id=\"diagram\">\n<h2>Diagram file</h2>\n{}{}</section>\n", parts_of(entry),
              painted_source(page_of(entry), entry.sources.front().path, sources));
}

/// Previous and next entry in the order of the gallery.
struct Neighbours {
  const GalleryEntry* previous = nullptr;
  const GalleryEntry* next = nullptr;
};

Neighbours neighbours_of(const Gallery& gallery, std::size_t index) {
  Neighbours result;
  if (index > 0) result.previous = &gallery.entries[index - 1];
  if (index + 1 < gallery.entries.size()) result.next = &gallery.entries[index + 1];
  return result;
}

Html way(const GalleryEntry* to, const GalleryEntry& from, const char* direction, const char* form) {
  if (!to) return html("<span class=\"{}\"></span>\n", direction);
  const Address address = address_from(page_of(from), page_of(*to));
  return html("<a class=\"{}\" rel=\"{}\" href=\"{}\" title=\"{}\">{}</a>\n", direction, direction, address,
              full_name(*to), html(form, short_name(*to)));
}

Html ways(const GalleryEntry& entry, const Neighbours& around, const char* name) {
  return html(
      "<nav class=\"bar\" aria-label=\"{}\">\n{}<a rel=\"up\" href=\"../index.html#figures\">All "
      "figures</a>\n{}</nav>\n",
      name, way(around.previous, entry, "prev", "<span aria-hidden=\"true\">←</span> {}"),
      way(around.next, entry, "next", "{} <span aria-hidden=\"true\">→</span>"));
}

Html head_of(const GalleryEntry& entry) {
  const ClaimTally tally = tally_of(entry);
  Html head = html("<header>\n");
  if (!entry.section.empty())
    head += html("<p class=\"place\">Chapter {} · Section {}</p>\n", chapter_of(entry), entry.section);
  head += html("<h1>{}</h1>\n", entry.label.empty()
                                    ? html("{}", entry.title)
                                    : html("<span class=\"label\">{}</span> {}", entry.label, entry.title));
  if (tally.all + tally.invariants + tally.broken + tally.errors > 0)
    head += html("<p class=\"summary {}\">{}</p>\n", tally.look(), tally.sentence());
  return head += html("</header>\n");
}

Html error_of(const GalleryEntry& entry) {
  return entry.error.empty() ? Html{} : html("<pre class=\"error\">{}</pre>\n", entry.error);
}

/// Returns the caption of the source beside that of the file.
Html beside(const GalleryEntry& entry) {
  Html source, here;
  if (!entry.source_caption.empty()) source += html("<p class=\"caption\">{}</p>\n", entry.source_caption);
  if (!entry.source_says.empty()) source += html("<p>{}</p>\n", entry.source_says);
  if (!source.empty())
    source = html(
        "<section class=\"source\">\n<h2>In the thesis</h2>\n<blockquote>\n{}</blockquote>\n</section>\n",
        source);
  if (!entry.caption.empty()) here = html("<p>{}</p>\n", entry.caption);
  for (const std::string& departure : entry.departures)
    here += html("<p class=\"departure\">{}</p>\n", departure);
  if (!here.empty()) here = html("<section class=\"here\">\n<h2>Here</h2>\n{}</section>\n", here);
  return html("<div class=\"beside\">\n{}{}</div>\n", source, here);
}

Html claim(const claim::Verdict& verdict) {
  const std::string value = verdict.note.empty() ? verdict.shown : verdict.note;
  Html item = html("<li class=\"{}\"><span class=\"verdict\">{}</span> <span class=\"that\">{}</span>",
                   look_of(verdict), verdict.word(), verdict.that);
  if (!value.empty()) item += html(" <span class=\"value\">{}</span>", value);
  if (!verdict.disagrees.empty()) item += html(" <em>{}</em>", verdict.disagrees);
  return item += html(" <code>{}</code></li>\n", verdict.check);
}

Html assumptions(const GalleryEntry& entry) {
  Html rows;
  for (const Assumption& one : entry.assumptions)
    rows += html("<tr><td><code>{}</code></td><td>{}</td><td>{}</td></tr>\n", one.name, one.value, one.doc);
  if (rows.empty()) return {};
  return html(
      "<section id=\"assumed\">\n<h2>Assumed</h2>\n<details>\n<summary>{} that the thesis does not "
      "give</summary>\n<table class=\"assumed\">\n<thead><tr><th scope=\"col\">Parameter</th><th "
      "scope=\"col\">Value</th><th "
      "scope=\"col\">Meaning</th></tr></thead>\n<tbody>\n{}</tbody></table>\n</details>\n</section>\n",
      counted(entry.assumptions.size(), "value", "values"), rows);
}

Html links_of(const GalleryEntry& entry, const Neighbours& around) {
  Html links = html("<link rel=\"up\" href=\"../index.html\">\n");
  const auto add = [&](const char* relation, const GalleryEntry* to) {
    if (to)
      links += html("<link rel=\"{}\" href=\"{}\">\n", relation, address_from(page_of(entry), page_of(*to)));
  };
  add("prev", around.previous);
  add("next", around.next);
  return links;
}

}  // namespace

Html claims_section(const GalleryEntry& entry) {
  Html stated, held;
  std::size_t count = 0;
  for (const claim::Verdict& verdict : entry.verdicts) {
    const bool folds = verdict.kind == claim::Claim::Kind::invariant && verdict.holds;
    (folds ? held : stated) += claim(verdict);
    count += folds ? 1 : 0;
  }
  if (entry.verdicts.empty()) return {};
  if (!stated.empty()) stated = html("<ul class=\"claims\">\n{}</ul>\n", stated);
  if (!held.empty())
    held = html(
        "<details id=\"invariants\">\n<summary>Held throughout: {}</summary>\n<ul "
        "class=\"claims\">\n{}</ul>\n</details>\n",
        count, held);
  const bool reads_pictures = std::ranges::any_of(entry.verdicts, [](const claim::Verdict& one) {
    return one.check.find("figure.") != std::string::npos;
  });
  Html names;
  if (reads_pictures)
    names = html(
        "<p class=\"soft\"><code>figure.2.y.3</code> is the third curve of the second picture, "
        "<code>figure.1.2.x</code> what the second panel of the first has along x.</p>\n");
  return html("<section id=\"claims\">\n<h2>Claims</h2>\n{}{}{}</section>\n", stated, held, names);
}

std::string entry_page(const Gallery& gallery, const GallerySources& sources, std::size_t index) {
  const GalleryEntry& entry = gallery.entries[index];
  const Neighbours around = neighbours_of(gallery, index);
  GalleryFrame frame{.page = page_of(entry), .title = full_name(entry), .look = "entry"};
  frame.navigation = ways(entry, around, "Gallery");
  frame.links = links_of(entry, around);
  Html content = html("{}{}{}", head_of(entry), error_of(entry), pictures_of(entry, false));
  content += html("{}{}{}", beside(entry), claims_section(entry), pictures_of(entry, true));
  content += html("{}{}", assumptions(entry), downloads_of(entry));
  content += html("{}{}", diagram_of(entry, sources), ways(entry, around, "Neighbours"));
  return framed(frame, content);
}

}  // namespace stepwire::gallery
