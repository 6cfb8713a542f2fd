#include "engine/replay/replay_folder.hpp"

#include <fmt/format.h>

#include "engine/diagram/flatten.hpp"
#include "engine/replay/data_copies.hpp"
#include "engine/table/file.hpp"

namespace stepwire {

void write_replay(const std::string& folder, const Plan& plan) {
  DataCopies copies;
  const std::string text =
      flattened_text(plan.diagram, [&](const std::string& path) { return "inputs/" + copies.name_of(path); });
  copies.write(folder + "/inputs");
  write_file(folder + "/" + flattened_name, text);
}

void write_replay(const std::string& folder, const Job& job) {
  if (job.points.empty()) return write_replay(folder, job.plan);
  DataCopies copies;
  const FileName name = [&](const std::string& path) { return "../inputs/" + copies.name_of(path); };
  for (std::size_t run = 0; run < job.points.size(); ++run)
    write_file(folder + "/" + flattened_name_of(run), flattened_text(job.points[run].plan.diagram, name));
  copies.write(folder + "/inputs");
}

std::set<std::string> files_read(const Plan& plan) {
  std::set<std::string> files;
  for (const ScopeInfo& scope : plan.diagram.scopes) files.insert(scope.file);
  flattened_text(plan.diagram, [&](const std::string& path) { return *files.insert(path).first; });
  return files;
}

std::set<std::string> files_read(const Job& job) {
  std::set<std::string> files = files_read(job.plan);
  for (const SweepPoint& point : job.points) files.merge(files_read(point.plan));
  return files;
}

std::string flattened_name_of(std::size_t run) {
  return fmt::format("diagrams/{:04}.yaml", run + 1);
}

}  // namespace stepwire
