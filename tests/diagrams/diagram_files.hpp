#pragma once

#include <functional>
#include <vector>

#include "engine/simulate/run/run.hpp"

namespace stepwire {

/// Calls `check` for every diagram file under diagrams/examples and diagrams/thesis, ready to run. Files
/// whose data are not on this machine are passed over with a warning.
void for_every_job(const std::function<void(run::Job job)>& check);

/// Returns every such diagram, one of those that have the same code and as many points.
std::vector<run::Job> distinct_jobs();

/// Of those that fit, the ones that each have a type of block that none before has.
std::vector<run::Job> jobs_of_all_blocks(const std::function<bool(const run::Job&)>& fits);

/// Calls `work` for each index, from as many threads as there are processors.
void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work);

/// The plan of a point of a sweep, loaded with the values of the point.
plan::Plan plan_at(const run::Job& job, std::size_t point);

/// The same with the plan of each, and those of the first and the last point of its sweep.
void for_every_diagram(const std::function<void(const plan::Plan& plan)>& check);

/// Returns a hash of all numbers of a run from its present tick up to `last`.
std::uint64_t fingerprint(run::Executor& simulation, std::int64_t last);

}  // namespace stepwire
