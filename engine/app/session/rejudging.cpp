#include "engine/app/session/rejudging.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <set>
#include <sstream>
#include <vector>

#include "engine/app/session/run_note.hpp"
#include "engine/app/session/run_result.hpp"
#include "engine/app/session/session.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/text/count.hpp"

namespace stepwire::session {

using json::Json;

namespace {

/// Returns a text of an object; empty if it has none.
std::string text_in(const Json& object, const char* key) {
  const Json* found = object.find(key);
  return found && found->as_text() ? *found->as_text() : "";
}

bool flag_in(const Json& object, const char* key) {
  const Json* found = object.find(key);
  return found && found->as_flag().value_or(false);
}

std::string without_blanks(const std::string& line) {
  const std::size_t first = line.find_first_not_of(' ');
  return first == line.npos ? "" : line.substr(first, line.find_last_not_of(" ,") - first + 1);
}

/// Recorded folder whose claims and tables are computed again.
class Folder {
 public:
  Folder(std::string folder, const Registry& registry, const Monitor& monitor)
      : folder_(std::move(folder)), registry_(registry), session_(registry, monitor) {}

  Rejudged compare() {
    Rejudged result = compare_all();
    result.note = head_note_;
    return result;
  }

 private:
  Rejudged compare_all() {
    if (!has("run.json")) return {};
    if (!has("claims.json")) return {path("claims.json") + ": is missing; every run writes it"};
    run_note_.emplace(folder_);
    note_ = run_note_->content();
    if (const std::string other = run_note_->difference_from_folder(registry_); !other.empty())
      return {other};
    const bool is_empty = read("claims.json").items().empty() && !has("study.json");
    const Json* faults = note_.find("faults");
    if (flag_in(note_, "interrupted") || (faults && !faults->items().empty())) return {};
    if (!read_study() || !load()) return {difference_, is_empty ? "" : left_out_};
    if (const std::string other = run_note_->difference_from(model_); !other.empty()) return {other};
    if (is_empty) return compare_number();
    return model_.study ? compare_study() : compare_run();
  }

  std::string path(const std::string& name) const { return (std::filesystem::path(folder_) / name).string(); }
  bool has(const std::string& name) const {
    std::error_code none;
    return std::filesystem::exists(path(name), none);
  }

  Json read(const std::string& name) const try {
    return Json::parse(io::read_file(path(name)));
  } catch (const json::JsonError& error) {
    throw yaml::Error(yaml::Fault{{path(name), {}}, "", yaml::Message(error.what()), {}});
  }

  /// Reads persons and seed of a study. Returns false for recorded trials and for several experiments.
  bool read_study() {
    if (!has("study.json")) return true;
    const Json study = read("study.json");
    const Json *points = study.find("points"),
               &one = points && !points->items().empty() ? points->items()[0] : study;
    const Json *seed = one.find("seed"), *trials = one.find("trials");
    if (!seed || !trials) left_out_ = "the trials of the study are recorded ones";
    if (one.find("experiments")) left_out_ = "the experiments of the study are not repeated";
    if (!left_out_.empty()) return false;
    std::set<std::string> subjects;
    for (const Json& trial : trials->items())
      if (const Json* subject = trial.find("subject")) subjects.insert(subject->text(-1));
    study_.subjects = subjects.size();
    study_.experiments = 1;
    study_.seed = static_cast<std::uint64_t>(seed->as_number().value_or(0.0));
    return true;
  }

  /// Loads the file of the run with the values that were set. Where that is another diagram, the step, stop
  /// and solver of the run are set, too.
  void load_with_values(const std::string& file) {
    LoadOptions options;
    options.study = study_;
    if (const Json* parameters = note_.find("parameters"))
      for (const Json& one : parameters->items())
        if (flag_in(one, "set")) options.settings.push_back({text_in(one, "name"), text_in(one, "written")});
    model_ = session_.load(file, options);
    if (model_.hash == text_in(note_, "hash")) return;
    for (const diagram::Setting& one : RunNote::head_settings(folder_, registry_))
      options.settings.push_back(one);
    model_ = session_.load(file, options);
    if (model_.hash == text_in(note_, "hash"))
      head_note_ = fmt::format(
          "{} has another step, stop or solver than the run, which its call may have set; those of the run "
          "are used",
          file);
  }

  /// Loads the file of the run with the values that were set. Returns false if it is another diagram now, or
  /// has other functions.
  bool load() {
    const std::string file = text_in(note_, "file");
    try {
      load_with_values(file);
    } catch (const yaml::Error&) {
      left_out_ = fmt::format("{} with the values of the run cannot be read now", file);
      return false;
    }
    if (model_.hash != text_in(note_, "hash"))
      difference_ = run_note_->other_hash(file);
    else if (!note_.find("functions"))
      left_out_ = "the run is of a version without the key 'functions', which had those of the C library";
    return difference_.empty() && left_out_.empty();
  }

  Rejudged compare_run() {
    const bool is_sweep = !model_.job.points.empty();
    const Outcome outcome = is_sweep ? session_.pass(model_) : session_.run(model_);
    const std::string ticks =
        outcome.result.interrupted ? "" : run_note_->difference_in_ticks(outcome.result.ticks);
    return ticks.empty() ? compare_claims(outcome) : Rejudged{ticks};
  }

  Rejudged compare_study() {
    const Studies::Shared experiments = session_.study(model_);
    const Outcome outcome = study_outcome(model_, *experiments);
    if (outcome.result.interrupted) return {{}, {}, true};
    for (const StudyFile& one : study_texts(model_, *experiments, outcome))
      if (const auto line = first_difference(path(one.name), one.text))
        return {fmt::format("{}:{}: is '{}', and '{}' when it is computed again", path(one.name),
                            line->number, line->there, line->computed)};
    return compare_claims(outcome);
  }

  /// Compares the number of claims where the file has none, without a run.
  Rejudged compare_number() const {
    if (model_.claims.empty()) return {};
    return {fmt::format("{}: has no claim, and {} has {}", path("claims.json"), model_.file,
                        text::counted(model_.claims.size(), "claim"))};
  }

  Rejudged compare_claims(const Outcome& outcome) const {
    if (outcome.result.interrupted) return {{}, {}, true};
    const std::string computed = result::json_of(judged_claims(model_, outcome)).text() + "\n";
    const auto line = first_difference(path("claims.json"), computed);
    if (!line) return {};
    return {fmt::format("{}:{}: the claim '{}' has {}, and {} when it is judged again", path("claims.json"),
                        line->number, claim_of(computed, line->number), without_blanks(line->there),
                        without_blanks(line->computed))};
  }

  /// Returns the statement of the claim that has a line.
  static std::string claim_of(const std::string& claims, std::size_t number) {
    std::istringstream lines(claims);
    std::string line, statement;
    const std::string key = "    \"that\": \"";
    for (std::size_t i = 1; std::getline(lines, line) && (i <= number || statement.empty()); ++i)
      if (line.starts_with(key)) statement = line.substr(key.size(), line.rfind('"') - key.size());
    return statement;
  }

  std::string folder_;
  const Registry& registry_;
  Session session_;
  std::optional<RunNote> run_note_;
  Json note_;
  study::StudyWords study_;
  LoadedModel model_;
  std::string left_out_, difference_, head_note_;
};

}  // namespace

std::optional<DifferentLine> first_difference(const std::string& path, const std::string& computed) {
  std::istringstream there(io::read_file(path)), here(computed);
  DifferentLine line{1, {}, {}};
  for (;; ++line.number) {
    line.there.clear();
    line.computed.clear();
    const bool more = static_cast<bool>(std::getline(there, line.there));
    const bool wants = static_cast<bool>(std::getline(here, line.computed));
    if (!more && !wants) return std::nullopt;
    if (more != wants || line.there != line.computed) return line;
  }
}

Rejudged rejudge(const std::string& folder, const Registry& registry, const Monitor& monitor) {
  return Folder(folder, registry, monitor).compare();
}

}  // namespace stepwire::session
