#include "engine/view/render/render.hpp"

#include "engine/view/drawing/draw.hpp"
#include "engine/view/plot/figure_spec.hpp"
#include "engine/view/render/gnuplot_renderer.hpp"
#include "engine/view/render/scene_drawing.hpp"
#include "engine/view/svg/table_drawing.hpp"

namespace stepwire {
namespace {

/// The renderer of what a figure shows.
struct Renderer {
  const FigureSpec& figure;

  Drawing operator()(const PlotSpec&) const { return render_gnuplot(figure); }
  Drawing operator()(const TextTable& table) const { return {draw(table), ""}; }
  Drawing operator()(const DrawnGraph& drawn) const { return {draw_picture(drawn.graph), ""}; }
  Drawing operator()(const SceneInstants& instants) const {
    return {scene_still(instants, figure.title), ""};
  }
};

}  // namespace

Drawing render(const FigureSpec& figure) {
  if (figure.panels.empty()) return render_gnuplot(figure);
  return std::visit(Renderer{figure}, figure.panels.front().content);
}

Drawing draw(const Figure& figure, std::span<const Recording> recordings) {
  return render(figure_spec(figure, recordings));
}

}  // namespace stepwire
