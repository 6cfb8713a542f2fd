#include "engine/app/session/kept_experiments.hpp"

#include <filesystem>

#include "engine/app/session/studies.hpp"
#include "engine/base/hash/hash.hpp"
#include "engine/base/io/file.hpp"
#include "engine/simulate/blockset/blockset.hpp"

namespace stepwire::session {

std::string experiments_note(const LoadedModel& model) {
  static const std::string program = hash::hash_of(io::read_file("/proc/self/exe"));
  json::Json note = json::Json::object().set("study", study_key(model, false)).set("program", program);
  std::vector<std::string> blocks;
  for (const std::string& folder : model.blocksets) blocks.push_back(blockset::blockset_hash(folder));
  if (!blocks.empty()) note.set("blocks", json::Json::list_of(blocks));
  return note.text() + "\n";
}

KeptExperiments::KeptExperiments(const LoadedModel& model, const std::string& folder)
    : model_(model), repetition_(study::outcome_columns(*model.study)) {
  if (folder.empty() || model.study->experiments == 1) return;
  path_ = folder + "/experiments.csv";
  const std::string note = folder + "/experiments.json";
  const std::string text = experiments_note(model);
  if (std::filesystem::exists(path_)) {
    if (!std::filesystem::exists(note) || io::read_file(note) != text)
      throw yaml::Error(yaml::Fault{
          {path_, {}},
          "",
          "has experiments of another study, or of another build of the program; give another --out",
          {}});
    repetition_.read(path_);
  }
  io::write_file(note, text);
}

std::vector<std::uint64_t> KeptExperiments::missing() const {
  const study::StudyRequest& request = *model_.study;
  const std::size_t points = study::study_count(model_.job);
  std::vector<std::uint64_t> seeds{request.seed};
  for (std::uint64_t seed = request.seed + 1; seed < request.seed + request.experiments; ++seed)
    if (!repetition_.has(seed, points)) seeds.push_back(seed);
  return seeds;
}

void KeptExperiments::add(const study::Experiments& experiments) {
  const std::lock_guard lock(mutex_);
  for (std::size_t point = 0; point < experiments.size(); ++point)
    repetition_.add({experiments[point].seed, study::outcome(experiments[point], *model_.study)}, point);
  if (!path_.empty()) io::write_file(path_, repetition_.csv());
}

void KeptExperiments::complete(study::Experiments& first) const {
  const study::StudyRequest& request = *model_.study;
  for (std::size_t point = 0; point < first.size(); ++point)
    for (study::ExperimentOutcome& one : repetition_.outcomes(point))
      if (one.seed > request.seed && one.seed < request.seed + request.experiments)
        first[point].others.push_back(std::move(one));
}

}  // namespace stepwire::session
