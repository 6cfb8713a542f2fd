#pragma once

#include <string_view>

namespace stepwire::svg {

/// Returns the width of a text in units of the font size, for the widest of the usual sans-serif fonts
/// (DejaVu Sans). It is narrower in Helvetica, Arial or Liberation Sans.
double text_width(std::string_view text);

/// Returns the preferred font size, reduced if needed so that the text fits into `room`.
double fitted_size(std::string_view text, double wanted, double room);

}  // namespace stepwire::svg
