#pragma once

#include "engine/model/diagram/definitions.hpp"
#include "engine/model/diagram/resolve.hpp"
#include "engine/model/diagram/scope.hpp"

namespace stepwire::diagram {

/// Reads title, step, stop, solver, thesis and caption of the diagram itself. Settings may replace step, stop
/// and solver.
void read_head(const Scope& scope, Settings& settings, Report& report);
/// Reads the sections that concern the file instead of a single run: sweep, figures, claims.
void read_head_of_file(const Scope& scope, Report& report);

/// Reads the sweep: lists of values, and ranges of them.
void read_sweep(const Scope& scope, Report& report);

/// Refuses unknown keys at the top level of a diagram file or part.
void check_head_keys(const Scope& scope, Report& report);

/// Reads `record` and `stop_when`, once all names are known.
void read_record(const Scope& scope, const Resolver& resolver, Report& report);
void read_stop_condition(const Scope& scope, const Resolver& resolver, Report& report);

/// Refuses a `stop_when` with incompatible units, once those of the signals are known.
void check_stop_condition(Report& report);
/// Refuses such formulas of `enable` and `trigger`.
void check_conditions(Report& report);

}  // namespace stepwire::diagram
