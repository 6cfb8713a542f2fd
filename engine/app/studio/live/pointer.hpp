#pragma once

#include <string>

#include "engine/app/session/loaded_model.hpp"

namespace stepwire::live {

/// Inputs that a page writes where the scene of a file has a `pointer`: where it is, [x, y] in the scene's
/// coordinates [m], and whether it holds the pin, 1 or 0.
inline constexpr const char *pointer_input = "pointer", *held_input = "pointer_held";
/// The hand that the pointer leads, a part of the model.
inline constexpr const char* pointer_part = "pointer_hand";

/// Loads a model for a page. Where its scene has a `pointer`, the model is a variant of the file: two inputs
/// and a hand that they lead (diagrams/parts/pointer-hand.yaml) are added, and whatever reads the signal of
/// who moves the pin in the file reads that of this hand. All else stays, who moved the pin among it,
/// unheard. So a run under a hand is a run of a diagram with inputs, and its log gives the same bits again.
/// The document of the file in the loader is the variant's then. Throws Error.
session::LoadedModel load_for_page(diagram::Loader& loader, const std::string& file,
                                   const session::LoadOptions& options = {});

/// Does the scene of a diagram have a `pointer`?
bool offers_pointer(const diagram::Diagram& diagram);
/// Is a model under the hand of a page: does it have the inputs of a pointer?
bool has_pointer(const diagram::Diagram& diagram);

}  // namespace stepwire::live
