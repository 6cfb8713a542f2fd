#pragma once

#include <string>

namespace stepwire::testing {

/// What the schema of a version of FMI finds wrong with a modelDescription.xml, or with a file of that name;
/// empty where that is nothing, and where STEPWIRE_DATA has no schemas or xmllint is missing.
std::string schema_fault(const std::string& path, int version, const std::string& schema = "ModelDescription");

}  // namespace stepwire::testing
