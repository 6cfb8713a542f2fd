#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "engine/app/cli/console.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/app/cli/interrupt.hpp"
#include "engine/app/cli/kept_inputs.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/cli/watch.hpp"
#include "engine/base/io/file.hpp"
#include "engine/view/drawing/graph_faults.hpp"
#include "engine/view/render/picture_kind.hpp"

namespace stepwire::cli {
namespace {

struct DrawCall {
  std::string file;
  drawing::GraphOptions options;
  std::string out;     ///< file; empty: standard output
  bool json = false;   ///< write the graph as JSON instead of the picture
  bool again = false;  ///< redraw after each change of a file
};

void require_names(const DrawCall& call, const drawing::DiagramView& view) {
  yaml::Faults faults;
  for (const drawing::GraphFault& fault : drawing::faults_of(view, call.options))
    faults.add({{call.file, {}}, "", fault.message, {}});
  faults.throw_if_any();
}

ExitCode draw(const DrawCall& call, diagram::Loader& loader) {
  const drawing::DrawnFile file(loader, call.file);
  require_names(call, file.view());
  keep_inputs(call.out, loader.paths());
  const EndDelay delay(EndDelay::Signals::first);
  const auto kind = call.json ? render::PictureKind::svg : render::picture_kind_of(call.out);
  const json::Json graph = file.view().graph(call.options);
  const std::string text =
      call.json ? graph.text() + "\n" : render::converted(drawing::draw_picture(graph), kind);
  if (call.out.empty()) {
    put_data(text);
  } else {
    io::write_file(call.out, text);
  }
  return ExitCode::done;
}

ExitCode draw_again(const DrawCall& call, const Registry& registry) {
  return watch([&](WatchedFiles& watched) {
    diagram::Loader loader(registry);
    watched.add(call.file);
    const ExitCode code = guarded([&] { return draw(call, loader); });
    watched.add(loader);
    say("{} {}: {}\n", time_of_day(), call.out, code == ExitCode::done ? "drawn" : "left as it was");
  });
}

Action declare_draw(CLI::App& verb) {
  const auto call = std::make_shared<DrawCall>();
  verb.add_option("FILE", call->file, "a diagram file, or one that is used as a part")->required();
  verb.add_option("-o,--out", call->out,
                  "SVG file to write, or PNG or PDF by its ending; SVG on the standard output without it")
      ->type_name("FILE");
  verb.add_option("--open", call->options.open, "parts whose inside is drawn: rig, rig.mount")
      ->delimiter(',');
  verb.add_option("--depth", call->options.depth, "open all parts down to so many levels")
      ->check(CLI::Range(0, 32))
      ->capture_default_str();
  verb.add_option("--hide", call->options.hide,
                  "blocks, parts and signals left out: work, rig.energy, 'peak*'")
      ->delimiter(',');
  verb.add_flag("--units", call->options.units, "write the unit of its signal on each wire");
  verb.add_flag("--json", call->json, "give the graph that is drawn, as JSON");
  verb.add_flag("--watch", call->again, "draw again when the file or a part of it changes, until Ctrl-C")
      ->needs("-o");
  return [call](const Registry& registry) {
    if (call->again) return draw_again(*call, registry);
    diagram::Loader loader(registry);
    return draw(*call, loader);
  };
}

}  // namespace

Verb draw_verb() {
  return {"draw", "draw a diagram as blocks and wires",
          "Example:\n  stepwire draw rig.yaml --open controller -o rig.svg", declare_draw};
}

}  // namespace stepwire::cli
