#pragma once

#include <string>

#include "blocks/records/record.hpp"
#include "blocks/records/step_options.hpp"

namespace stepwire {

/// Applies a list of steps in order, each to the whole record. An empty map has no steps. Calls `refuse`,
/// which throws, for unknown steps and for records that a step does not support.
void prepare_record(Record& record, const Value& steps, const StepOptions::Refuse& refuse);

/// Returns every step in the syntax of a file, and its effect.
std::string preparation_help();

}  // namespace stepwire
