#include "blocks/register.hpp"
#include "engine/stepwire/blocks.hpp"

namespace stepwire {

Model load(const std::string& path, const NamedTexts& settings) {
  return load(path, blocks(), settings);
}

}  // namespace stepwire
