#pragma once

#include <string>

#include "engine/app/simulink/model.hpp"

namespace stepwire::simulink {

/// Reads a file .slx of R2012a and later. Throws yaml::Error, with one sentence, for another format, damaged
/// or hostile files and files beyond the limits, and EnvironmentError for an unreadable file.
Model read_model(const std::string& path);

}  // namespace stepwire::simulink
