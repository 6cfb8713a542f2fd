#include "engine/app/session/result_folder.hpp"

#include <set>
#include <utility>

#include "engine/simulate/replay/replay_folder.hpp"

namespace stepwire::session {

std::unique_ptr<io::OwnedFolder> own_results(const std::string& folder, const LoadedModel& model) {
  if (folder.empty()) return nullptr;
  auto owned = std::make_unique<io::OwnedFolder>(folder, [&] {
    std::set<std::string> files = replay::files_read(model.job);
    files.insert({folder + "/experiments.csv", folder + "/experiments.json"});
    if (model.study && !model.study->trials.empty()) files.insert(model.study->trials);
    return files;
  });
  owned->reserve({"signals.csv", "signals.mat", "claims.json", "run.json"});
  return owned;
}

}  // namespace stepwire::session
