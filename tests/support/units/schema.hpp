#pragma once

#include <string>

namespace stepwire::testing {

/// Validates a modelDescription.xml, or a file of another schema of this version of FMI, and returns the
/// fault. The result is empty if it is valid, if STEPWIRE_DATA has no schemas, or if xmllint is missing.
std::string schema_fault(const std::string& path, int version, const std::string& schema = "ModelDescription");

}  // namespace stepwire::testing
