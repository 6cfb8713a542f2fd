#include "engine/model/diagram/diagram.hpp"

namespace stepwire::diagram {

yaml::Fault Diagram::fault(const Origin& origin, std::string subject, yaml::Message message) const {
  yaml::Fault fault{place(origin), std::move(subject), std::move(message), {}};
  const auto user_of = [this](int scope) { return scopes[static_cast<std::size_t>(scope)].used_at; };
  // Neither the diagram file itself nor a setting has a user.
  for (Origin user = user_of(origin.scope); user.scope >= 0; user = user_of(user.scope))
    fault.used_by.push_back(place(user));
  return fault;
}

}  // namespace stepwire::diagram
