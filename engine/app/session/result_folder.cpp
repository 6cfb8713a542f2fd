#include "engine/app/session/result_folder.hpp"

#include <set>
#include <utility>

#include "engine/app/session/kept_points.hpp"
#include "engine/simulate/replay/replay_folder.hpp"

namespace stepwire::session {

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
