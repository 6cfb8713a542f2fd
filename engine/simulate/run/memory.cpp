#include "engine/simulate/run/memory.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "engine/base/io/environment_error.hpp"
#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::run {

namespace {

constexpr double bytes_of_number = 2 * sizeof(double);  // as a column, as text of a file

/// The first number of a file of the system; 0 if there is none.
double number_in(const char* file, const std::string& label = "") {
  std::ifstream stream(file);
  std::string word;
  while (!label.empty() && stream >> word && word != label) {
  }
  double number = 0.0;
  return stream >> number ? number : 0.0;
}

/// What the machine, or the container in it, has left [bytes].
double free_memory() {
  double available = 1024.0 * number_in("/proc/meminfo", "MemAvailable:");
  if (available <= 0.0)
    available = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  const double limit = number_in("/sys/fs/cgroup/memory.max");
  return limit > 0.0 ? std::min(available, limit - number_in("/sys/fs/cgroup/memory.current")) : available;
}

std::string gigabytes(double bytes) {
  return fmt::format("{:.3g} GB", bytes * 1e-9);
}

void require(const diagram::Diagram& diagram, const diagram::Origin& origin, const std::string& subject,
             double bytes, const std::string& what, const std::string& cure) {
  const double available = free_memory();
  if (bytes <= available) return;
  throw io::EnvironmentError(diagram
                                 .fault(origin, subject,
                                        fmt::format("{} take about {}, and {} are free; {}", what,
                                                    gigabytes(bytes), gigabytes(available), cure))
                                 .text());
}

struct Extent {
  double rows = 0.0, numbers = 0.0;
};

/// What one entry of `record` keeps of one run; of a sweep that may be a row.
Extent extent_of(const plan::Plan& plan, const diagram::RecordRequest& request, bool one_row) {
  const double ticks = request.every ? *request.every / plan.diagram.step : 1.0;
  const double rows = one_row ? 1.0 : static_cast<double>(plan.steps) / ticks + 1.0;
  double columns = 1.0;
  for (const diagram::RecordedSignal& signal : request.signals)
    columns += static_cast<double>(plan.slot(signal.signal).size);
  return {rows, rows * columns};
}

}  // namespace

void require_memory(const Job& job) {
  const diagram::Diagram& diagram = job.plan.diagram;
  const bool one_row = !job.points.empty() && !job.trials && diagram.sweep &&
                       diagram.sweep->keep != diagram::Sweep::Keep::rows;
  for (std::size_t r = 0; r < diagram.records.size(); ++r) {
    Extent all;
    const auto add = [&](const plan::Plan& plan) {
      const Extent one = extent_of(plan, plan.diagram.records[r], one_row);
      all.rows += one.rows;
      all.numbers += one.numbers;
    };
    if (job.points.empty()) add(job.plan);
    for (std::size_t point = 0; point < job.points.size(); ++point) add(job.plan_of(point));
    require(diagram, diagram.records[r].origin, "record", bytes_of_number * all.numbers,
            fmt::format("{:.3g} rows with {:.3g} numbers", all.rows, all.numbers),
            "give 'record' an 'every', or record fewer signals");
  }
}

void require_solver_memory(const plan::Plan& plan) {
  if (!solve::find_implicit(plan.diagram.solver)) return;
  const double states = static_cast<double>(plan.layout.state_count);
  require(plan.diagram, plan.diagram.solver_origin, "solver", 2.0 * sizeof(double) * states * states,
          fmt::format("the matrices of {} states", states), "an explicit solver needs none");
}

}  // namespace stepwire::run
