#pragma once

#include <string>

#include "engine/model/plan/plan.hpp"

namespace stepwire {

/// The header of a generated program: a struct with inputs, outputs and recorded signals as members.
std::string struct_text(const Plan& plan, const std::string& name);

/// Its member functions, on top of evaluate(), advance() and reset() of the GeneratedProgram.
std::string struct_definitions(const Plan& plan, const std::string& name);

/// The member of `recorded` that a recorded signal is.
std::string recorded_member(const RecordedSignal& signal);

}  // namespace stepwire
