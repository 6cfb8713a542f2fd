#pragma once

#include <string>

namespace stepwire::cli {

/// Puts a tar archive of all in a folder on the standard output, by way of a file beside it: its entries in
/// the order of their names, without times and owners, so that the same files give the same bytes. Throws
/// EnvironmentError.
void put_archive(const std::string& folder, const std::string& file);

}  // namespace stepwire::cli
