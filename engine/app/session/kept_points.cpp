#include "engine/app/session/kept_points.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/app/session/ordered_points.hpp"
#include "engine/app/session/version.hpp"
#include "engine/base/hash/hash.hpp"
#include "engine/base/io/owned_folder.hpp"
#include "engine/base/yaml/yaml_text.hpp"
#include "engine/simulate/replay/replay_folder.hpp"
#include "engine/simulate/run/pooling.hpp"

namespace stepwire::session {

using json::Json;

namespace {

/// Returns a hash of everything that determines the results of a sweep, with the values of all points.
std::string points_hash(const LoadedModel& model) {
  hash::Hash hash;
  hash.add(model.hash).add(build_note(model).text(-1));
  const diagram::Sweep& sweep = *model.job.plan.diagram.sweep;
  hash.add(fmt::format("{} {} {}", static_cast<int>(sweep.keep), yaml::yaml_line(sweep.kept),
                       sweep.recorded_runs));
  for (std::size_t point = 0; point < model.job.points.size(); ++point)
    hash.add(run::settings_text(model.job.settings_of(point)));
  return hash.text();
}

[[noreturn]] void refuse(const std::string& folder, yaml::Message message) {
  throw yaml::Error(yaml::Fault{{points_path(folder), {}}, "", std::move(message), {}});
}

std::string text_of(const Json& object, const char* key) {
  const Json* value = object.find(key);
  const std::string* text = value ? value->as_text() : nullptr;
  return text ? *text : "";
}

LoadOptions options_of(const Json& head) {
  LoadOptions options;
  if (const Json* settings = head.find("settings"))
    for (const Json& setting : settings->items())
      options.settings.push_back(
          {text_of(setting, "name"), text_of(setting, "value"), text_of(setting, "written")});
  if (const Json* stop = head.find("stop"); stop && stop->as_text()) options.stop = *stop->as_text();
  if (const Json* large = head.find("large"); large && large->as_flag().value_or(false))
    options.limits = replay::wide_limits;
  return options;
}

/// Formatter of ascending numbers that joins consecutive ones to ranges.
class Neighbours {
 public:
  void add(std::size_t number) {
    if (count_ > 0 && number == last_ + 1 && open_) {
      last_ = number;
    } else {
      close();
      first_ = last_ = number;
      open_ = true;
    }
    ++count_;
  }

  std::string text() {
    close();
    if (more_ > 0) texts_.push_back(fmt::format("{} more", more_));
    return fmt::format("{}", fmt::join(texts_, ", "));
  }

 private:
  static constexpr std::size_t most_shown = 5;

  void close() {
    if (!open_) return;
    open_ = false;
    if (texts_.size() >= most_shown)
      more_ += last_ - first_ + 1;
    else
      texts_.push_back(first_ == last_ ? fmt::format("{}", first_) : fmt::format("{} to {}", first_, last_));
  }

  std::vector<std::string> texts_;
  std::size_t first_ = 0, last_ = 0, count_ = 0, more_ = 0;
  bool open_ = false;
};

bool is_missing(const std::vector<journal::Journal*>& journals, std::size_t point) {
  return std::ranges::none_of(journals, [&](const journal::Journal* journal) { return journal->has(point); });
}

std::optional<run::PointResult> point_of(const std::vector<journal::Journal*>& journals, KeptPoints* halves,
                                         std::size_t point) {
  for (journal::Journal* journal : journals)
    if (auto result = journal->point(point)) return result;
  return halves ? halves->half(point) : std::nullopt;
}

}  // namespace

std::string points_path(const std::string& folder) {
  return folder + "/points.journal";
}

std::string items_path(const std::string& folder, const std::string& of) {
  return folder + "/" + of + ".journal";
}

std::string points_head(const LoadedModel& model) {
  Json settings = Json::list();
  for (const diagram::Setting& setting : model.options.settings)
    settings.push(
        Json::object().set("name", setting.name).set("value", setting.value).set("written", setting.written));
  return Json::object()
      .set("file", model.file)
      .set("settings", std::move(settings))
      .set("stop", model.options.stop ? Json(*model.options.stop) : Json())
      .set("large", model.options.limits.bytes > yaml::DocumentLimits{}.bytes)
      .set("points", model.job.points.size())
      .set("hash", points_hash(model))
      .text(-1);
}

LoadedModel load_kept(const Registry& registry, const std::string& folder) {
  const auto text = journal::Journal::head_of(points_path(folder));
  if (!text) refuse(folder, "is no file of points; 'run FILE --part K/N --out DIR' writes it");
  const Json head = Json::parse(*text);
  const std::string file = text_of(head, "file");
  LoadedModel model = load_model(registry, file, options_of(head));
  if (points_head(model) != *text)
    refuse(folder,
           fmt::format("has points of another state of {}, of its data, or of another build of the program; "
                       "run its points again",
                       file));
  return model;
}

KeptPoints::KeptPoints(const LoadedModel& model, const std::string& folder, const Share& share)
    : journal_((io::note_written(points_path(folder)), points_path(folder)), points_head(model), model.job,
               model.kept.get(), journal::Journal::Use::write),
      first_(share.first(model.job.points.size())),
      end_(share.end(model.job.points.size())),
      next_(first_) {
  found_ = kept();
}

std::optional<std::size_t> KeptPoints::next() {
  for (std::size_t point = next_++; point < end_; point = next_++)
    if (!journal_.has(point)) return point;
  return std::nullopt;
}

void KeptPoints::take(run::PointResult result) {
  if (!result.end.interrupted) return journal_.add(result);
  const std::lock_guard lock(mutex_);
  halves_.push_back(std::move(result));
}

std::optional<run::PointResult> KeptPoints::half(std::size_t point) {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find(halves_, point, &run::PointResult::point);
  return found == halves_.end() ? std::nullopt : std::optional(std::move(*found));
}

double KeptPoints::done() const {
  return points() == 0 ? 1.0 : static_cast<double>(journal_.count()) / static_cast<double>(points());
}

std::size_t KeptPoints::kept() const {
  std::size_t count = 0;
  for (std::size_t point = first_; point < end_; ++point) count += journal_.has(point);
  return count;
}

Outcome joined_points(const LoadedModel& model, const std::vector<journal::Journal*>& journals,
                      const RowUse& use, KeptPoints* halves) {
  const std::size_t points = model.job.points.size();
  if (goes_run_by_run(model, use)) {
    StreamingJudge passed(model, use);
    for (std::size_t point = 0; point < points; ++point)
      if (auto result = point_of(journals, halves, point)) passed.add(std::move(*result));
    return passed.take();
  }
  run::RunOptions options;
  options.numbers = model.kept.get();
  run::JoinedPoints joined(model.job, options);
  for (std::size_t point = 0; point < points; ++point)
    if (auto result = point_of(journals, halves, point)) joined.take(std::move(*result));
  Outcome outcome;
  outcome.result = joined.result();
  judge_claims(model, outcome);
  return outcome;
}

std::string missing_points(const LoadedModel& model, const std::vector<journal::Journal*>& journals) {
  Neighbours missing;
  for (std::size_t point = 0; point < model.job.points.size(); ++point)
    if (is_missing(journals, point)) missing.add(point + 1);
  return missing.text();
}

}  // namespace stepwire::session
