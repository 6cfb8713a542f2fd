#pragma once

#include <map>
#include <string>

#include <stepwire/model.hpp>

namespace stepwire {

/// Options of a generated program.
struct GenerateOptions {
  std::string name{};                ///< name of the program; empty: that of the file
  bool c_interface = false;          ///< adds a header and a source for C
  bool constant_parameters = false;  ///< parameters are literals in the code and cannot change
};

/// Returns a model as C++ that is built without stepwire: the text of each file by its path, as `stepwire
/// generate` writes them. Throws Error for anything that cannot be generated, with its line.
std::map<std::string, std::string> generated_files(const Model& model, const GenerateOptions& options = {});

/// Creates a folder and writes the files into it.
void generate(const Model& model, const std::string& folder, const GenerateOptions& options = {});

/// Returns "0.1.0".
const char* version();

}  // namespace stepwire
