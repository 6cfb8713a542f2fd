#pragma once

#include <string>

#include "blocks/records/record.hpp"
#include "blocks/records/step_options.hpp"

namespace stepwire {

/// Works through a list of steps, in order; each sees the whole record. An empty map is no step. Calls
/// `refuse`, which throws, for what is none of the steps and for a record that a step cannot take.
void prepare_record(Record& record, const Value& steps, const StepOptions::Refuse& refuse);

/// Every step as a file writes it, and what it does.
std::string preparation_help();

}  // namespace stepwire
