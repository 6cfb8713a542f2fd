#pragma once

#include <string>

#include "engine/app/session/loaded_model.hpp"

namespace stepwire::live {

/// Inputs that a page writes if the scene has a `pointer`. The first one is its position [x, y] in the
/// scene's coordinates [m]; the second one is 1 while it holds the pin, else 0.
inline constexpr const char *pointer_input = "pointer", *held_input = "pointer_held";

/// Loads a model for a page. If its scene has a `pointer`, the model is a variant of the file. It gets two
/// inputs and a hand that follows them (diagrams/parts/pointer-hand.yaml). All readers of the signal that
/// moves the pin read the signal of the hand instead; the original source remains, without effect. A run with
/// a pointer is thus a run of a diagram with inputs, and its log reproduces the same bits. The loader's
/// document of the file becomes the variant. Throws Error.
session::LoadedModel load_for_page(diagram::Loader& loader, const std::string& file,
                                   const session::LoadOptions& options = {});

/// True if the scene of a diagram has a `pointer`.
bool offers_pointer(const diagram::Diagram& diagram);
/// True if a model has the inputs of a pointer.
bool has_pointer(const diagram::Diagram& diagram);

}  // namespace stepwire::live
