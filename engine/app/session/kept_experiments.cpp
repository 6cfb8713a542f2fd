#include "engine/app/session/kept_experiments.hpp"

#include <filesystem>

#include "engine/app/session/studies.hpp"
#include "engine/base/hash/hash.hpp"
#include "engine/base/io/file.hpp"

namespace stepwire {

std::string experiments_note(const LoadedModel& model) {
  static const std::string program = hash_of(read_file("/proc/self/exe"));
  return Json::object().set("study", study_key(model, false)).set("program", program).text() + "\n";
}

KeptExperiments::KeptExperiments(const LoadedModel& model, const std::string& folder)
    : model_(model), repetition_(outcome_columns(*model.study)) {
  if (folder.empty() || model.study->experiments == 1) return;
  path_ = folder + "/experiments.csv";
  const std::string note = folder + "/experiments.json";
  const std::string text = experiments_note(model);
  if (std::filesystem::exists(path_)) {
    if (!std::filesystem::exists(note) || read_file(note) != text)
      throw Error(
          Fault{{path_, {}},
                "",
                "has experiments of another study, or of another build of the program; give another --out",
                {}});
    repetition_.read(path_);
  }
  write_file(note, text);
}

std::vector<std::uint64_t> KeptExperiments::missing() const {
  const StudyRequest& request = *model_.study;
  const std::size_t points = study_count(model_.job);
  std::vector<std::uint64_t> seeds{request.seed};
  for (std::uint64_t seed = request.seed + 1; seed < request.seed + request.experiments; ++seed)
    if (!repetition_.has(seed, points)) seeds.push_back(seed);
  return seeds;
}

void KeptExperiments::add(const Experiments& experiments) {
  const std::lock_guard lock(mutex_);
  for (std::size_t point = 0; point < experiments.size(); ++point)
    repetition_.add({experiments[point].seed, outcome(experiments[point], *model_.study)}, point);
  if (!path_.empty()) write_file(path_, repetition_.csv());
}

void KeptExperiments::complete(Experiments& first) const {
  const StudyRequest& request = *model_.study;
  for (std::size_t point = 0; point < first.size(); ++point)
    for (ExperimentOutcome& one : repetition_.outcomes(point))
      if (one.seed > request.seed && one.seed < request.seed + request.experiments)
        first[point].others.push_back(std::move(one));
}

}  // namespace stepwire
