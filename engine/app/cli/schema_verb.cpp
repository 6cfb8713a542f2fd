#include "engine/app/cli/console.hpp"
#include "engine/app/cli/verb.hpp"
#include "engine/app/reference/diagram_schema.hpp"

namespace stepwire::cli {

namespace {

Action declare_schema(CLI::App&) {
  return [](const Registry& registry) {
    put_json(reference::diagram_schema(registry));
    return ExitCode::done;
  };
}

}  // namespace

Verb schema_verb() {
  return {"schema", "print the JSON schema of diagram files, for editors",
          "Example:\n  stepwire schema > stepwire.schema.json\n  # first line of a diagram file:\n"
          "  # yaml-language-server: $schema=stepwire.schema.json",
          declare_schema};
}

}  // namespace stepwire::cli
