#pragma once

#include <stepwire/model.hpp>

namespace stepwire {

// These are of the target stepwire::blocks.

/// All blocks of the reference. The type is complete in <stepwire/registry.hpp>.
Registry blocks();

/// Loads a diagram that uses these blocks alone.
Model load(const std::string& path, const NamedTexts& settings = {});

}  // namespace stepwire
