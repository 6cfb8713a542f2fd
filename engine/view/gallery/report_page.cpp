#include "engine/view/gallery/report_page.hpp"

#include <cmath>

#include "engine/base/text/base64.hpp"
#include "engine/view/gallery/gallery_page.hpp"
#include "engine/view/gallery/gallery_picture.hpp"

namespace stepwire::gallery {
namespace {

/// Returns a text as the address of an image, so that the page has it inside.
std::string data_address(const std::string& svg) {
  return "data:image/svg+xml;base64," + text::base64(svg);
}

Html report_picture(const ReportPicture& picture) {
  GalleryPicture size;
  read_picture(size, picture.svg);
  const Html image =
      html("<img{} src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\" style=\"max-width: 100%; height: auto\">",
           html(size.dark ? "" : " class=\"plain\""), html("{}", data_address(picture.svg)),
           static_cast<std::size_t>(std::lround(size.width)),
           static_cast<std::size_t>(std::lround(size.height)), picture.alt);
  const std::string title = picture.title.empty() ? size.title : picture.title;
  return html("<figure>{}\n<figcaption><strong>{}</strong> {}</figcaption></figure>\n", image, title,
              picture.caption);
}

Html report_section(const char* title, const std::vector<ReportPicture>& pictures) {
  Html all;
  for (const ReportPicture& picture : pictures) all += report_picture(picture);
  return all.empty() ? all : html("<section>\n<h2>{}</h2>\n{}</section>\n", title, all);
}

Html report_row(const std::vector<std::string>& cells, const char* cell) {
  Html row;
  for (const std::string& text : cells) row += html(cell, text);
  return html("<tr>{}</tr>\n", row);
}

Html report_section(const ReportTable& table) {
  Html rows;
  for (const std::vector<std::string>& row : table.rows) rows += report_row(row, "<td>{}</td>");
  const Html note = table.note.empty() ? Html{} : html("<p class=\"soft\">{}</p>\n", table.note);
  if (rows.empty() && note.empty()) return {};
  if (!rows.empty())
    rows = html("<table>\n<thead>{}</thead>\n<tbody>\n{}</tbody></table>\n",
                report_row(table.head, "<th scope=\"col\">{}</th>"), rows);
  return html("<section>\n<h2>{}</h2>\n{}{}</section>\n", table.title, note, rows);
}

/// Returns the texts of the diagram file and its parts.
Html report_sources(const GalleryEntry& entry) {
  Html all;
  for (const GallerySource& source : entry.sources)
    all += html("<details>\n<summary>{}</summary>\n<pre class=\"yaml\">{}</pre>\n</details>\n", source.path,
                painted_yaml(source.text, [](const std::string&) { return Address{}; }));
  return all.empty() ? all : html("<section>\n<h2>Files</h2>\n{}</section>\n", all);
}

std::string report_place(std::size_t index) {
  return fmt::format("model-{}", index + 1);
}

Html report_content(const Report& report, std::size_t index) {
  const GalleryEntry& entry = report.entry;
  const ClaimTally tally = tally_of(entry);
  Html content = html("<h1 id=\"{}\">{}</h1>\n", report_place(index), entry.title);
  if (!entry.caption.empty()) content += html("<p class=\"lead\">{}</p>\n", entry.caption);
  if (!entry.verdicts.empty() || !entry.error.empty())
    content += html("<p class=\"summary {}\">{}</p>\n", tally.look(), tally.sentence());
  if (!entry.error.empty()) content += html("<pre class=\"error\">{}</pre>\n", entry.error);
  content += html("{}{}{}", report_section("Drawing", report.drawings),
                  report_section("Figures", report.figures), claims_section(entry));
  for (const ReportTable& table : report.tables) content += report_section(table);
  return html("<article>\n{}{}</article>\n", content, report_sources(entry));
}

/// Returns the list of the models, each with its verdict.
Html report_contents(const std::vector<Report>& reports) {
  Html list;
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const ClaimTally tally = tally_of(reports[i].entry);
    list += html("<li class=\"{}\"><a href=\"#{}\">{}</a> <span class=\"soft\">{}</span></li>\n",
                 tally.look(), report_place(i), reports[i].entry.title, tally.sentence());
  }
  return reports.size() < 2 ? Html{} : html("<nav aria-label=\"Models\"><ol>\n{}</ol></nav>\n", list);
}

}  // namespace

std::string report_page(const std::string& title, const std::vector<Report>& reports) {
  GalleryFrame frame{.page = "report.html", .title = title, .look = "entry", .contained = true};
  Html content = report_contents(reports);
  for (std::size_t i = 0; i < reports.size(); ++i) content += report_content(reports[i], i);
  return framed(frame, content);
}

}  // namespace stepwire::gallery
