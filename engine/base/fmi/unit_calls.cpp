#include "engine/base/fmi/unit_calls.hpp"

#include <cstdio>

namespace stepwire::fmi {

namespace {

constexpr int last_status = 5;  // Pending in FMI 2

}  // namespace

bool UnitCalls::accept(const char* name, int status) {
  if (!is_fault(status)) return true;
  failed_ = true;
  const bool known = status > 0 && status <= last_status;
  char text[200];  // a buffer on the stack, since a run must not allocate
  if (known)
    std::snprintf(text, sizeof text, "%s failed, and the unit gives no reason", name);
  else
    std::snprintf(text, sizeof text, "%s returned the status %d, which FMI does not have", name, status);
  if (!known) log_.clear();
  fault_.take(text);
  return false;
}

}  // namespace stepwire::fmi
