#include "engine/view/gallery/gallery_downloads.hpp"

#include <array>
#include <filesystem>

#include "engine/view/gallery/gallery_tally.hpp"

namespace stepwire::gallery {
namespace {

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

}  // namespace

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

Html diagram_of(const GalleryEntry& entry, const GallerySources& sources) {
  if (entry.sources.empty()) return {};
  return html("<section id=\"diagram\">\n<h2>Diagram file</h2>\n{}{}</section>\n", parts_of(entry),
              painted_source(page_of(entry), entry.sources.front().path, sources));
}

}  // namespace stepwire::gallery
