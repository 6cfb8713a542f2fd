#pragma once

#include <map>
#include <string>

#include <stepwire/model.hpp>

namespace stepwire {

/// What a program is made with.
struct GenerateOptions {
  std::string name{};                ///< of the program; empty: that of the file
  bool c_interface = false;          ///< a header and a source to call it from C as well
  bool constant_parameters = false;  ///< parameters as numbers in the code, which cannot be changed then
};

/// A model as C++ that is built without stepwire: the text of each file by its path, as `stepwire generate`
/// writes them. Throws Error for what cannot be generated, with its line.
std::map<std::string, std::string> generated_files(const Model& model, const GenerateOptions& options = {});

/// Writes them into a folder, which is made.
void generate(const Model& model, const std::string& folder, const GenerateOptions& options = {});

/// Returns the version of the library: "major.minor.patch".
const char* version();

}  // namespace stepwire
