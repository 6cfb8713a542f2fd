#pragma once

#include <functional>
#include <string>

#include "engine/run/run.hpp"

namespace stepwire {

/// Calls `check` for every diagram file under diagrams/examples and diagrams/thesis with its plan, and with
/// those of the first and the last point of its sweep. Files whose data are not on this machine are passed
/// over with a warning.
void for_every_diagram(const std::function<void(const Plan& plan)>& check);

/// A number that stands for all bits of a run from its present tick to `last`.
std::uint64_t fingerprint(Simulation& simulation, std::int64_t last);

}  // namespace stepwire
