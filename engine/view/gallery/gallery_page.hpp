#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <functional>
#include <map>
#include <string>

#include "engine/view/gallery/gallery.hpp"

namespace stepwire::gallery {

/// HTML text. Only html() converts other texts to HTML; it escapes them.
struct Html {
  std::string code;

  bool empty() const { return code.empty(); }
  Html& operator+=(const Html& more) {
    code += more.code;
    return *this;
  }
};

/// Path relative to the page that contains it; special characters are percent-encoded.
struct Address {
  std::string path;
};

std::string html_piece(const Html& html);
std::string html_piece(const std::string& text);
inline std::string html_piece(const char* text) {
  return html_piece(std::string(text));
}
std::string html_piece(const Address& address);
inline std::string html_piece(std::size_t number) {
  return fmt::format("{}", number);
}

/// Fills the placeholders {} of a template: HTML is copied, texts and addresses are escaped.
template <typename... Pieces>
Html html(fmt::string_view form, const Pieces&... pieces) {
  return {fmt::format(fmt::runtime(form), html_piece(pieces)...)};
}

/// Returns "1 value", "2 values".
std::string counted(std::size_t count, const std::string& one, const std::string& several);

/// Returns the address of one path of the gallery on the page of another.
Address address_from(const std::string& page, const std::string& target);

/// Frame of a page of the gallery around its content.
struct GalleryFrame {
  std::string page;        ///< path in the gallery: "fig15-map/index.html"
  std::string title;       ///< title of the window
  Html navigation{};       ///< before the content
  Html links{};            ///< links of the head
  std::string look = "";   ///< CSS class of the body
  bool contained = false;  ///< true for a page with its style inside, without other files
};

/// Returns the whole page.
std::string framed(const GalleryFrame& frame, const Html& content);

/// Number of claims and their results; invariants are counted separately.
struct ClaimTally {
  std::size_t all = 0, hold = 0, known = 0, fail = 0, surprise = 0, errors = 0;
  std::size_t invariants = 0, broken = 0;

  void count(const GalleryEntry& entry);
  void count(const claim::Verdict& verdict);
  bool bad() const { return fail + surprise + errors + broken > 0; }
  /// Returns the CSS class of the result: bad, known or good.
  std::string look() const { return bad() ? "bad" : known > 0 ? "known" : "good"; }
  /// Returns "6 of 7 claims hold, 1 known not to hold, 4 invariants held throughout."
  std::string sentence() const;
};

ClaimTally tally_of(const GalleryEntry& entry);
ClaimTally tally_of(const std::vector<GalleryEntry>& entries);

/// Returns the claims of an entry. Invariants that held are summarised in one line; broken ones are listed
/// with the claims.
Html claims_section(const GalleryEntry& entry);

/// Returns the CSS class of a verdict.
std::string look_of(const claim::Verdict& verdict);

/// Returns "Figure 15", or the title of an entry without a label.
std::string short_name(const GalleryEntry& entry);
/// Returns "Figure 15: Force over a map".
std::string full_name(const GalleryEntry& entry);
/// Returns the path of its page in the gallery.
std::string page_of(const GalleryEntry& entry);

/// Function that returns the address of the page of a part, by its path in the file; an empty address without
/// a page.
using PartAddress = std::function<Address(const std::string& path)>;

/// Returns a YAML text as HTML: spans of the classes key, comment, string, number, name and type, and links
/// at its parts.
Html painted_yaml(const std::string& text, const PartAddress& part);

/// Diagram files of a gallery, each once, by their paths in it.
using GallerySources = std::map<std::string, std::string>;

GallerySources sources_of(const Gallery& gallery);

/// Returns the path of the page of a diagram file.
std::string page_of_source(const std::string& path);

/// Returns a diagram file with syntax colours, for a page of the gallery; its parts are links to their pages.
Html painted_source(const std::string& page, const std::string& path, const GallerySources& sources);

/// Returns the page of a diagram file, with links to the entries that use it.
std::string source_page(const Gallery& gallery, const GallerySources& sources, const std::string& path);

/// Returns the page of one entry. It contains the pictures, the text of the source beside the own one,
/// claims, assumptions, downloads and the diagram file, with links to its neighbours.
std::string entry_page(const Gallery& gallery, const GallerySources& sources, std::size_t index);

}  // namespace stepwire::gallery
