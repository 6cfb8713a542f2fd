#include "engine/analyse/study/study_items.hpp"

#include "engine/analyse/study/study_columns.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/simulate/journal/run_bytes.hpp"
#include "engine/simulate/run/row_per_run.hpp"

namespace stepwire::study {
namespace {

using messages::all;
using messages::ByteReader;
using messages::ByteWriter;
using messages::list;
using messages::plain_list;

/// Serialises a trial without its recordings.
template <class Stream, class Trial>
void trial(Stream& stream, Trial& of) {
  all(stream, of.seed, of.study, of.subject, of.condition, of.practice, of.order, of.attempts, of.done);
  plain_list(stream, of.failures);
  list(stream, of.point.own, [&](auto& one) { journal::setting(stream, one); });
  journal::run_end(stream, of.result);
  list(stream, of.begun, [&](auto& one) { plain_list(stream, one); });
  list(stream, of.left, [&](auto& one) { plain_list(stream, one); });
  all(stream, of.end, of.end_point[0], of.end_point[1]);
}

void require(bool whole) {
  if (!whole) throw io::EnvironmentError("a trial of another process is not as it was sent");
}

}  // namespace

std::string StudyItems::work(const messages::Item& item) const {
  return item.number < people_ ? person(item.number) : experiment(request_.seed + item.number - people_);
}

std::string StudyItems::person(std::size_t number) const {
  const std::vector<TrialRun> runs =
      run_person(runs_, request_, person_of(request_, request_.seed, number), {});
  ByteWriter writer;
  list(writer, runs, [&](const TrialRun& one) {
    trial(writer, one);
    const bool has_rows = !one.result.recordings.empty();
    all(writer, has_rows);
    for (const record::Recording& recording : one.result.recordings) journal::rows(writer, recording.table);
  });
  return writer.take();
}

/// Reads a person's trials. Their plans are found again in this process.
std::vector<TrialRun> StudyItems::person_of_bytes(std::string_view bytes) const {
  ByteReader reader(bytes);
  std::vector<TrialRun> runs;
  list(reader, runs, [&](TrialRun& one) {
    trial(reader, one);
    bool has_rows = false;
    all(reader, has_rows);
    require(reader.whole());
    one.point.member = runs_.family()->find(one.point.own);
    if (!has_rows) return;
    one.result.recordings = run::empty_recordings(runs_.family()->plan(one.point.member), nullptr);
    for (record::Recording& recording : one.result.recordings) journal::rows(reader, recording.table);
  });
  require(reader.whole());
  return runs;
}

std::string StudyItems::experiment(std::uint64_t seed) const {
  ByteWriter writer;
  ExperimentSink sink;
  sink.done = [&](const Experiments& experiments) {
    for (const Experiment& one : experiments) {
      const std::vector<NamedValue> values = outcome(one, request_);
      for (const OutcomeColumn& column : outcome_columns(request_)) writer.put(value_of(values, column.name));
    }
  };
  perform(runs_, request_, job_, {seed}, sink);
  return writer.take();
}

std::vector<std::vector<NamedValue>> StudyItems::outcomes_of(std::string_view bytes) const {
  ByteReader reader(bytes);
  std::vector<std::vector<NamedValue>> outcomes(study_count(job_));
  for (std::vector<NamedValue>& values : outcomes)
    for (const OutcomeColumn& column : outcome_columns(request_)) {
      values.push_back({column.name, 0.0});
      reader.get(values.back().value);
    }
  require(reader.whole());
  return outcomes;
}

Experiments StudyItems::perform_by(messages::ItemWorkers& workers, const std::vector<std::uint64_t>& seeds,
                                   const Done& done) const {
  std::vector<messages::Item> items;
  for (std::size_t person = 0; person < people_; ++person) items.push_back({person});
  for (std::size_t i = 1; i < seeds.size(); ++i) items.push_back({people_ + seeds[i] - request_.seed});
  const std::vector<std::string> results = workers.run(items);
  std::vector<std::vector<TrialRun>> people;
  for (std::size_t person = 0; person < people_; ++person) people.push_back(person_of_bytes(results[person]));
  for (std::size_t i = 1; i < seeds.size(); ++i) done(seeds[i], outcomes_of(results[people_ + i - 1]));
  return experiments_of(std::move(people), request_.seed, runs_.family(), request_, job_);
}

}  // namespace stepwire::study
