#pragma once

#include "blocks/sources/from_file.hpp"

namespace stepwire {

/// Reads what a FromFile asks for, in SI, cut to its range and prepared; refuses its parameters where the
/// file does not fit them.
Samples read_samples(const FromFile& asked, Configure& is);

}  // namespace stepwire
