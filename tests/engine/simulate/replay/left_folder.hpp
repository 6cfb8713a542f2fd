#pragma once

#include <string>

#include "engine/app/session/signal_files.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire {

/// Runs a diagram file of the folder and leaves in `out` what `run --out` would, with files of these kinds.
void leave(const DiagramFolder& folder, const std::string& file, const std::string& out,
           const session::FileKinds& kinds = session::usual_files);

/// Replaces a text that is in a file of the folder.
void change(const DiagramFolder& folder, const std::string& file, const std::string& what,
            const std::string& by);

/// Returns the text of verify() for a folder, or the message of its refusal without the path.
std::string verdict_of(const DiagramFolder& folder, const std::string& out);

}  // namespace stepwire
