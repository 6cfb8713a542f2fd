#include "engine/view/gallery/gallery.hpp"

#include "engine/view/gallery/gallery_entry.hpp"
#include "engine/view/gallery/gallery_front.hpp"
#include "engine/view/gallery/gallery_script.hpp"
#include "engine/view/gallery/gallery_source.hpp"
#include "engine/view/gallery/gallery_style.hpp"
#include "engine/view/gallery/gallery_tally.hpp"

namespace stepwire::gallery {

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
