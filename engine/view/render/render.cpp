#include "engine/view/render/render.hpp"

#include "engine/base/io/file.hpp"
#include "engine/view/drawing/draw.hpp"
#include "engine/view/plot/figure_spec.hpp"
#include "engine/view/render/gnuplot_renderer.hpp"
#include "engine/view/render/scene_drawing.hpp"
#include "engine/view/svg/table_drawing.hpp"

namespace stepwire::render {
namespace {

/// Renderer for each content of a figure.
struct Renderer {
  const plot::FigureSpec& figure;

  Drawing operator()(const plot::PlotSpec&) const { return render_gnuplot(figure); }
  Drawing operator()(const text::TextTable& table) const { return {svg::draw(table), ""}; }
  Drawing operator()(const plot::DrawnGraph& drawn) const { return {drawing::draw_picture(drawn.graph), ""}; }
  Drawing operator()(const plot::SceneInstants& instants) const {
    return {scene_still(instants, figure.title), ""};
  }
};

}  // namespace

Drawing render(const plot::FigureSpec& figure) {
  if (figure.panels.empty()) return render_gnuplot(figure);
  return std::visit(Renderer{figure}, figure.panels.front().content);
}

Drawing draw(const plot::Figure& figure, std::span<const record::Recording> recordings) {
  return render(plot::figure_spec(figure, recordings));
}

void write_figure(const std::string& folder, const std::string& name, const plot::FigureSpec& figure,
                  const std::string& json_name, const PictureKinds& kinds) {
  const std::string svg = render(figure).svg;
  for (const PictureKind kind : kinds)
    io::write_file(folder + "/" + name + ending_of(kind), converted(svg, kind));
  io::write_file(folder + "/" + (json_name.empty() ? name : json_name) + ".json",
                 plot::figure_json(figure).text(-1) + "\n");
}

}  // namespace stepwire::render
