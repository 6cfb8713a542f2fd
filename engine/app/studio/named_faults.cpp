#include "engine/app/studio/named_faults.hpp"

#include "engine/app/session/fault_json.hpp"

namespace stepwire::studio {

using json::Json;

namespace {

/// Returns the object of a place or fault with the listed name of its file in place of the path.
Json with_name(Json object, const DiagramFiles& files) {
  const Json* path = object.find("file");
  if (path && path->as_text()) object.set("file", files.name(*path->as_text()));
  return object;
}

}  // namespace

Json faults_with_names(const DiagramFiles& files, const std::vector<yaml::Fault>& faults) {
  const Json all = session::faults_json(faults);
  Json list = Json::list();
  for (const Json& fault : all.items()) {
    Json users = Json::list();
    if (const Json* used_by = fault.find("used_by"))
      for (const Json& user : used_by->items()) users.push(with_name(user, files));
    list.push(with_name(fault, files).set("used_by", std::move(users)));
  }
  return list;
}

Fault named_faults(Desk& desk, const yaml::Error& error) {
  const std::lock_guard lock(desk.mutex);
  std::vector<yaml::Fault> shown = error.faults();
  for (yaml::Fault& fault : shown) {
    fault.place.file = desk.files.name(fault.place.file);
    for (yaml::Place& user : fault.used_by) user.file = desk.files.name(user.file);
  }
  return Fault(yaml::Error(std::move(shown)).what(),
               Json::object().set("faults", faults_with_names(desk.files, error.faults())));
}

}  // namespace stepwire::studio
