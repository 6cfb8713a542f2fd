#pragma once

#include <map>
#include <string>

#include <stepwire/model.hpp>

namespace stepwire {

/// A model as C++ that is built without stepwire: the text of each file by its path, as `stepwire generate`
/// writes them. Throws Error for what cannot be generated, with its line.
std::map<std::string, std::string> generated_files(const Model& model);

/// Writes them into a folder, which is made.
void generate(const Model& model, const std::string& folder);

/// "0.1.0"
const char* version();

}  // namespace stepwire
