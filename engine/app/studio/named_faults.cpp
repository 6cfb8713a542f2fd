#include "engine/app/session/fault_json.hpp"
#include "engine/app/studio/calls.hpp"

namespace stepwire::studio {

using json::Json;

namespace {

/// The object of a place or a fault with another name of its file.
Json with_name(Json object, const DiagramFiles& files) {
  const Json* path = object.find("file");
  if (path && path->as_text()) object.set("file", files.name(*path->as_text()));
  return object;
}

}  // namespace

Fault named_faults(Desk& desk, const yaml::Error& error) {
  const std::lock_guard lock(desk.mutex);
  const Json all = session::faults_json(error.faults());
  Json faults = Json::list();
  for (const Json& fault : all.items()) {
    Json users = Json::list(), named = with_name(fault, desk.files);
    if (const Json* used_by = fault.find("used_by"))
      for (const Json& user : used_by->items()) users.push(with_name(user, desk.files));
    faults.push(std::move(named.set("used_by", std::move(users))));
  }
  std::vector<yaml::Fault> shown = error.faults();
  for (yaml::Fault& fault : shown) {
    fault.place.file = desk.files.name(fault.place.file);
    for (yaml::Place& user : fault.used_by) user.file = desk.files.name(user.file);
  }
  return Fault(yaml::Error(std::move(shown)).what(), Json::object().set("faults", std::move(faults)));
}

}  // namespace stepwire::studio
