#include "engine/app/session/kept_experiments.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "engine/app/session/studies.hpp"
#include "engine/app/session/version.hpp"
#include "engine/base/io/file.hpp"

namespace stepwire::session {
namespace {

/// Refuses a link, whose target is outside this folder.
void refuse_link(const std::string& file) {
  std::error_code none;
  if (std::filesystem::is_symlink(std::filesystem::symlink_status(file, none)))
    throw io::EnvironmentError(fmt::format(
        "{}: is a link; experiments are kept in a file of this folder: remove the link, and they are "
        "performed again",
        file));
}

/// Returns the seed of the experiment whose trials are in the folder.
std::uint64_t performed_seed(const std::string& folder) {
  const json::Json study = json::Json::parse(io::read_file(folder + "/study.json"));
  const json::Json* points = study.find("points");
  const json::Json* seed =
      (points && !points->items().empty() ? points->items().front() : study).find("seed");
  return seed ? static_cast<std::uint64_t>(seed->as_number().value_or(0.0)) : 0;
}

}  // namespace

std::string experiments_note(const LoadedModel& model) {
  const json::Json build = build_note(model);
  json::Json note = json::Json::object().set("study", study_key(model, false));
  for (const auto& [key, value] : build.members()) note.set(key, value);
  return note.text() + "\n";
}

KeptExperiments::KeptExperiments(const LoadedModel& model, const std::string& folder)
    : model_(model), repetition_(study::outcome_columns(*model.study)) {
  if (folder.empty() || model.study->experiments == 1) return;
  path_ = folder + "/experiments.csv";
  const std::string note = folder + "/experiments.json";
  const std::string text = experiments_note(model);
  for (const std::string& file : {path_, note}) refuse_link(file);
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

void KeptExperiments::add(std::uint64_t seed, const std::vector<std::vector<study::NamedValue>>& outcomes) {
  const std::lock_guard lock(mutex_);
  for (std::size_t point = 0; point < outcomes.size(); ++point)
    repetition_.add({seed, outcomes[point]}, point);
}

void KeptExperiments::complete(study::Experiments& first) const {
  const study::StudyRequest& request = *model_.study;
  for (std::size_t point = 0; point < first.size(); ++point)
    for (study::ExperimentOutcome& one : repetition_.outcomes(point))
      if (one.seed > request.seed && one.seed < request.seed + request.experiments)
        first[point].others.push_back(std::move(one));
}

std::string not_replayed(const std::string& folder) {
  const std::string path = folder + "/experiments.csv";
  if (!std::filesystem::exists(path)) return {};
  refuse_link(path);
  const std::uint64_t seed = performed_seed(folder);
  std::set<std::uint64_t> others;
  for (const auto& [key, values] : study::read_kept_rows(path).rows)
    if (key.first != seed) others.insert(key.first);
  if (others.empty()) return {};
  return fmt::format(
      "replayed is experiment 1 (seed {}); not replayed {} (seed{} {}) of experiments.csv, whose checks fit "
      "their numbers",
      seed, others.size() == 1 ? "is 1 other" : fmt::format("are {} others", others.size()),
      others.size() == 1 ? "" : "s", fmt::join(others, ", "));
}

}  // namespace stepwire::session
