#include "engine/app/studio/page_table.hpp"
namespace stepwire::studio {
std::span<const PageFile> page_table() {
  return {};
}
}  // namespace stepwire::studio
