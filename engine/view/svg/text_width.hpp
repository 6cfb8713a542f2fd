#pragma once

#include <string_view>

namespace stepwire::svg {

/// Width of a text in sizes of its font, in the widest of the usual fonts without serifs (DejaVu Sans): in
/// Helvetica, Arial or Liberation Sans it is narrower.
double text_width(std::string_view text);

/// The size of a font, at most `wanted`, in which a text is no wider than `room`.
double fitted_size(std::string_view text, double wanted, double room);

}  // namespace stepwire::svg
