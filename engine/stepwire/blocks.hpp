#pragma once

#include <stepwire/model.hpp>

namespace stepwire {

// Functions of the target stepwire::blocks.

/// Returns all blocks of the reference. The type is defined in <stepwire/registry.hpp>.
Registry blocks();

/// Loads a diagram that uses these blocks only.
Model load(const std::string& path, const NamedTexts& settings = {});

}  // namespace stepwire
