#include "engine/base/yaml/yaml_message.hpp"

#include <array>

namespace stepwire::yaml {
namespace {

struct Wording {
  std::string_view library, ours;
};

constexpr std::array wordings{
    Wording{"illegal map value",
            "a ': ' cannot stand here; check the indentation, look for a missing ':' just above, "
            "or quote text that holds ': '"},
    Wording{"end of map not found",
            "expected 'key: value' here; check the indentation, and quote text that holds ': ' or starts "
            "with a sign"},
    Wording{"end of map flow not found",
            "expected ',' or '}' here; a ',', a bracket or a quote is missing (text that holds ': ' or ', ' "
            "needs quotes)"},
    Wording{"end of sequence not found", "expected '- ' here; check the indentation"},
    Wording{"end of sequence flow not found",
            "expected ',' or ']' here; a ',', a bracket or a quote is missing"},
    Wording{"illegal flow end", "this bracket closes nothing, or not the kind that was opened last"},
    Wording{"illegal block entry", "a '- ' cannot stand here; put it on a line of its own"},
    Wording{"illegal map key", "a key cannot stand here; check the indentation"},
    Wording{"unknown token", "this character starts nothing in YAML; put quotes around the text"},
    Wording{"illegal document indicator in scalar",
            "'---' or '...' inside a text; a closing quote is missing"},
    Wording{"illegal tab when looking for indentation", "a tab in the indentation; use blanks"},
    Wording{"the referenced anchor is not defined",
            "the alias (*name) names no anchor (&name) before it; quote text that starts with *"},
    Wording{"alias not found after *", "a name is missing after '*'; quote text that starts with *"},
    Wording{"anchor not found after &", "a name is missing after '&'; quote text that starts with &"},
    Wording{"cannot assign multiple anchors to the same node", "a value can have one anchor (&name) only"},
    Wording{"bad file", "nested too deeply to be read"},
};

}  // namespace

std::string yaml_message(std::string_view library_message) {
  for (const Wording& wording : wordings)
    if (wording.library == library_message) return std::string(wording.ours);
  return "not valid YAML: " + std::string(library_message);
}

}  // namespace stepwire::yaml
