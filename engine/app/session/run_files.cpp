#include "engine/app/session/run_files.hpp"

#include <set>
#include <utility>

#include "engine/app/session/kept_points.hpp"
#include "engine/app/session/run_result.hpp"
#include "engine/base/io/file.hpp"
#include "engine/simulate/replay/replay_folder.hpp"
#include "engine/simulate/run/pooling.hpp"
#include "engine/view/plot/figure_spec.hpp"
#include "engine/view/render/render.hpp"
#include "engine/view/render/scene_drawing.hpp"

namespace stepwire::session {

namespace {

void write_scene(const std::string& folder, const LoadedModel& model, const Outcome& outcome,
                 std::vector<std::string>& pictures) {
  pictures.emplace_back("scene.svg");
  io::write_file(
      folder + "/" + pictures.back(),
      render::animated_scene(*model.scene, model.file, outcome.recordings(), model.job.plan.diagram.title));
}

}  // namespace

std::vector<std::string> write_outputs(const std::string& folder, const LoadedModel& model,
                                       const Outcome& outcome, const FileKinds& kinds,
                                       const render::PictureKinds& drawn) {
  if (!outcome.rows_passed) write_signals(folder, model, outcome.result.recordings, kinds);
  io::write_file(folder + "/claims.json", result::json_of(judged_claims(model, outcome)).text() + "\n");
  io::write_file(folder + "/run.json", result::json_of(RunReport{&model, &outcome}).text() + "\n");
  std::vector<std::string> pictures;
  // The recordings of an early end are kept, but a picture of them could be mistaken for that of a whole run.
  if (!outcome.result.faults.empty() || outcome.result.interrupted) return pictures;
  for (std::size_t i = 0; i < model.figures.size(); ++i) {
    const std::string name = io::numbered("figure", i, "");
    for (const render::PictureKind kind : drawn) pictures.push_back(name + render::ending_of(kind));
    render::write_figure(folder, name, plot::figure_spec(model.figures[i], outcome.recordings()), {}, drawn);
  }
  if (model.scene) write_scene(folder, model, outcome, pictures);
  return pictures;
}

std::unique_ptr<io::OwnedFolder> own_results(const std::string& folder, const LoadedModel& model,
                                             const FileKinds& kinds) {
  if (folder.empty()) return nullptr;
  auto owned = std::make_unique<io::OwnedFolder>(folder, [&] {
    std::set<std::string> files = replay::files_read(model.job);
    files.insert({folder + "/experiments.csv", folder + "/experiments.json", points_path(folder)});
    for (const char* of : {"study", "fit", "tune"}) files.insert(items_path(folder, of));
    if (model.study && !model.study->trials.empty()) files.insert(model.study->trials);
    return files;
  });
  std::vector<std::string> names = signal_file_names(kinds);
  names.insert(names.end(), {"claims.json", "run.json"});
  owned->reserve(names);
  return owned;
}

}  // namespace stepwire::session
