#include "engine/base/fmi/foreign_call.hpp"

#include <algorithm>
#include <cstring>

namespace stepwire::fmi {

ForeignCall::ForeignCall(CallNote& note, const char* name) : note_(note) {
  const std::size_t length = std::min(std::strlen(name), CallNote::room - 1);
  std::memcpy(note.name, name, length);
  note.name[length] = '\0';
  count();
}

std::string CallNote::text() const {
  return {name, ::strnlen(name, room)};
}

}  // namespace stepwire::fmi
