#include "engine/view/render/figure_file.hpp"
#include "engine/view/render/render.hpp"

#include "engine/base/io/file.hpp"

namespace stepwire::render {

void write_figure(const std::string& folder, const std::string& name, const plot::FigureSpec& figure,
                  const std::string& json_name, const PictureKinds& kinds) {
  const std::string svg = render(figure).svg;
  for (const PictureKind kind : kinds)
    io::write_file(folder + "/" + name + ending_of(kind), converted(svg, kind));
  io::write_file(folder + "/" + (json_name.empty() ? name : json_name) + ".json",
                 plot::figure_json(figure).text(-1) + "\n");
}

}  // namespace stepwire::render
