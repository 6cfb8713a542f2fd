#include "engine/diagram/diagram.hpp"

namespace stepwire {

Fault Diagram::fault(const Origin& origin, std::string subject, std::string message) const {
  Fault fault{place(origin), std::move(subject), std::move(message), {}};
  for (int scope = origin.scope; scope != 0; scope = scopes[static_cast<std::size_t>(scope)].used_at.scope)
    fault.used_by.push_back(place(scopes[static_cast<std::size_t>(scope)].used_at));
  return fault;
}

}  // namespace stepwire
