#include "engine/simulate/run/memory.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "engine/base/io/environment_error.hpp"
#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/solve/solver.hpp"

namespace stepwire::run {

namespace {

constexpr double bytes_of_number = 2 * sizeof(double);  // in a column and as text of a file

/// Returns the first number in a file of the system, after `label`; 0 if there is none.
double number_in(const char* file, const std::string& label = "") {
  std::ifstream stream(file);
  std::string word;
  while (!label.empty() && stream >> word && word != label) {
  }
  double number = 0.0;
  return stream >> number ? number : 0.0;
}

/// Returns the memory that the machine, its container and the process limit leave [bytes].
double free_memory() {
  double available = 1024.0 * number_in("/proc/meminfo", "MemAvailable:");
  if (available <= 0.0)
    available = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  const double limit = number_in("/sys/fs/cgroup/memory.max");
  if (limit > 0.0) available = std::min(available, limit - number_in("/sys/fs/cgroup/memory.current"));
  struct rlimit data {};  // limit of 'ulimit -d'
  if (::getrlimit(RLIMIT_DATA, &data) != 0 || data.rlim_cur == RLIM_INFINITY) return available;
  return std::min(available,
                  static_cast<double>(data.rlim_cur) - 1024.0 * number_in("/proc/self/status", "VmData:"));
}

std::string gigabytes(double bytes) {
  return fmt::format("{:.3g} GB", bytes * 1e-9);
}

/// Returns "3e+08 rows with 9e+08 numbers take about 14.4 GB, and 8.2 GB are free". Returns std::nullopt if
/// they fit.
std::optional<std::string> lack(double bytes, const std::string& what) {
  const double available = free_memory();
  if (bytes <= available) return std::nullopt;
  return fmt::format("{} take about {}, and {} are free", what, gigabytes(bytes), gigabytes(available));
}

[[noreturn]] void refuse(const diagram::Diagram& diagram, const diagram::Origin& origin,
                         const std::string& subject, const std::string& lack, const std::string& cure) {
  throw io::EnvironmentError(diagram.fault(origin, subject, lack + "; " + cure).text());
}

struct Extent {
  double rows = 0.0, numbers = 0.0;

  std::optional<std::string> lack() const {
    return run::lack(bytes_of_number * numbers,
                     fmt::format("{:.3g} rows with {:.3g} numbers", rows, numbers));
  }
};

bool keeps_one_row(const Job& job) {
  const auto& sweep = job.plan.diagram.sweep;
  return !job.points.empty() && !job.trials && sweep && sweep->keep != diagram::Sweep::Keep::rows;
}

/// Returns the extent of one entry of `record` for one run; with `one_row`, that of a single row.
Extent extent_of(const plan::Plan& plan, std::size_t record, bool one_row) {
  const diagram::RecordRequest& request = plan.diagram.records[record];
  const double ticks = request.every ? *request.every / plan.diagram.step : 1.0;
  const double rows = one_row ? 1.0 : static_cast<double>(plan.steps) / ticks + 1.0;
  double columns = 1.0;
  for (const diagram::RecordedSignal& signal : request.signals)
    columns += static_cast<double>(plan.slot(signal.signal).size);
  return {rows, rows * columns};
}

/// Returns the extent for all runs together.
Extent extent_of_all(const Job& job, std::size_t record) {
  const bool one_row = keeps_one_row(job);
  if (job.points.empty()) return extent_of(job.plan, record, one_row);
  Extent all;
  const auto swept = static_cast<double>(job.plan.diagram.sweep->axes.size());
  const auto add = [&](std::size_t point, bool row) {
    const Extent one = extent_of(job.plan_of(point), record, row);
    all.rows += one.rows;
    all.numbers += one.numbers + one.rows * swept;
  };
  for (std::size_t point = 0; point < job.points.size(); ++point) add(point, one_row);
  for (const std::size_t point : job.plan.diagram.sweep->recorded_points()) add(point, false);
  return all;
}

/// Returns the extent for the largest run.
Extent extent_of_run(const Job& job, std::size_t record) {
  Extent most = extent_of(job.plan, record, false);
  for (std::size_t member = 0; job.family && member < job.family->size(); ++member) {
    const Extent one = extent_of(job.family->plan(member), record, false);
    if (one.numbers > most.numbers) most = one;
  }
  return most;
}

void refuse_rows(const Job& job, std::size_t record, const std::string& lack) {
  const diagram::Diagram& diagram = job.plan.diagram;
  refuse(diagram, diagram.records[record].origin, "record", lack,
         "give 'record' an 'every', or record fewer signals");
}

}  // namespace

void require_memory(const Job& job) {
  for (std::size_t r = 0; r < job.plan.diagram.records.size(); ++r) {
    if (const auto lack = extent_of_run(job, r).lack()) refuse_rows(job, r, *lack);
    if (!keeps_one_row(job)) continue;
    if (const auto lack = extent_of_all(job, r).lack()) refuse_rows(job, r, *lack);
  }
}

std::optional<std::string> lack_for_all_rows(const Job& job) {
  for (std::size_t r = 0; r < job.plan.diagram.records.size(); ++r)
    if (auto lack = extent_of_all(job, r).lack()) return lack;
  return std::nullopt;
}

void require_memory_of_all_rows(const Job& job) {
  for (std::size_t r = 0; r < job.plan.diagram.records.size(); ++r)
    if (const auto lack = extent_of_all(job, r).lack()) refuse_rows(job, r, *lack);
}

double most_numbers(const Job& job) {
  double most = 0.0;
  for (std::size_t r = 0; r < job.plan.diagram.records.size(); ++r)
    most = std::max(most, extent_of_all(job, r).numbers);
  return most;
}

void require_solver_memory(const plan::Plan& plan) {
  if (!solve::find_called(plan.diagram.solver, plan.diagram.error_control.has_value())) return;
  const double states = static_cast<double>(plan.layout.state_count);
  if (const auto lack =
          run::lack(4.0 * sizeof(double) * states * states, fmt::format("the matrices of {} states", states)))
    refuse(plan.diagram, plan.diagram.solver_origin, "solver", *lack, "an explicit solver needs none");
}

}  // namespace stepwire::run
