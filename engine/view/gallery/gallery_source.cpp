#include "engine/view/gallery/gallery_source.hpp"

#include <algorithm>
#include <filesystem>

#include "engine/view/gallery/gallery_tally.hpp"
#include "engine/view/gallery/gallery_yaml.hpp"

namespace stepwire::gallery {
namespace {

namespace fs = std::filesystem;

std::string file_name(const std::string& path) {
  return fs::path(path).filename().string();
}

bool uses(const GalleryEntry& entry, const std::string& path) {
  return std::ranges::any_of(entry.sources, [&](const GallerySource& source) { return source.path == path; });
}

Html users_of(const Gallery& gallery, const std::string& path, const std::string& page) {
  Html links;
  for (const GalleryEntry& entry : gallery.entries)
    if (uses(entry, path))
      links += html("{}<a href=\"{}\">{}</a>", links.empty() ? "" : ", ", address_from(page, page_of(entry)),
                    short_name(entry));
  return html("<p>Used by {}.</p>\n", links);
}

}  // namespace

GallerySources sources_of(const Gallery& gallery) {
  GallerySources sources;
  for (const GalleryEntry& entry : gallery.entries)
    for (const GallerySource& source : entry.sources) sources[source.path] = source.text;
  return sources;
}

std::string page_of_source(const std::string& path) {
  return path + ".html";
}

Html painted_source(const std::string& page, const std::string& path, const GallerySources& sources) {
  const PartAddress part = [&](const std::string& written) {
    const std::string target = (fs::path(path).parent_path() / written).lexically_normal().generic_string();
    return sources.contains(target) ? address_from(page, page_of_source(target)) : Address{};
  };
  return html("<pre class=\"yaml\" tabindex=\"0\" role=\"region\" aria-label=\"{}\"><code>{}</code></pre>\n",
              file_name(path), painted_yaml(sources.at(path), part));
}

std::string source_page(const Gallery& gallery, const GallerySources& sources, const std::string& path) {
  const std::string page = page_of_source(path);
  GalleryFrame frame{.page = page, .title = file_name(path), .look = "source"};
  const Address up = address_from(page, "index.html");
  frame.navigation =
      html("<nav class=\"bar\" aria-label=\"Gallery\"><a rel=\"up\" href=\"{}\">All figures</a></nav>\n", up);
  const Html head = html("<h1>{}</h1>\n<p><a href=\"{}\" download>Download {}</a></p>\n", file_name(path),
                         Address{file_name(path)}, file_name(path));
  return framed(frame,
                html("{}{}{}", head, users_of(gallery, path, page), painted_source(page, path, sources)));
}

}  // namespace stepwire::gallery
