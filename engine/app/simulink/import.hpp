#pragma once

#include <string>

#include "engine/app/simulink/import_result.hpp"
#include "engine/model/block/registry.hpp"

namespace stepwire::simulink {

/// An import: the file of Simulink, and the file to write.
struct ImportCall {
  std::string model;  ///< X.slx
  std::string out;    ///< X.yaml; parts are in the folder X-parts beside it
};

/// Writes a Simulink model as a diagram. Blocks without counterpart become parts that end a run. Throws
/// yaml::Error for a file that is no such model, and EnvironmentError.
ImportResult import_model(const ImportCall& call, const Registry& registry);

/// Returns the table of the translated types as Markdown.
std::string translations_markdown();

}  // namespace stepwire::simulink
