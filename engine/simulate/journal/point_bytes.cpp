#include "engine/simulate/journal/point_bytes.hpp"

#include "engine/simulate/journal/run_bytes.hpp"
#include "engine/simulate/record/recorder.hpp"

namespace stepwire::journal {

namespace {

/// True if the result has as many rows as its run can produce.
bool fits(const run::PointResult& result, const run::Job& job, const run::RunNumbers* numbers) {
  const plan::Plan& plan = job.plan_of(result.point);
  const bool one_row = run::keeps_a_row(job, numbers);
  for (std::size_t r = 0; r < result.recordings.size(); ++r) {
    const std::size_t rows = result.recordings[r].table.rows();
    const std::size_t behind = numbers && r > 0 ? 1 : 0;  // rows that are kept beside numbers
    if (one_row && behind == 0 ? rows != 1 : rows > record::max_rows(plan, plan.diagram.records[r - behind]))
      return false;
  }
  return true;
}

}  // namespace

std::string bytes_of(const run::PointResult& result) {
  messages::ByteWriter writer;
  writer.put<std::uint64_t>(result.point);
  run_end(writer, result.end);
  for (const record::Recording& recording : result.recordings) rows(writer, recording.table);
  return writer.take();
}

std::optional<run::PointResult> point_of(std::string_view bytes, const run::Job& job,
                                         const run::RunNumbers* numbers) {
  messages::ByteReader reader(bytes);
  run::PointResult result;
  std::uint64_t point = 0;
  reader.get(point);
  if (!reader.whole() || point >= job.points.size()) return std::nullopt;
  result.point = point;
  run_end(reader, result.end);
  result.recordings = run::empty_recordings(job, result.point, numbers);
  for (record::Recording& recording : result.recordings) rows(reader, recording.table);
  if (!reader.whole() || !reader.at_end() || !fits(result, job, numbers)) return std::nullopt;
  return result;
}

}  // namespace stepwire::journal
