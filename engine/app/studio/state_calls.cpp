#include <fmt/format.h>

#include "engine/app/studio/calls.hpp"

namespace stepwire::studio {

using json::Json;

namespace {

Json get(Desk& desk, const std::string& path) {
  const std::lock_guard lock(desk.mutex);
  const std::string layout = desk.store.layout(path);
  return Json::object().set("state", layout.empty() ? Json() : Json::parse(layout));
}

Json put(Desk& desk, const std::string& path, std::size_t most, const Arguments& arguments) {
  const std::string layout = arguments.any("state").text(-1);
  if (layout.size() > most) throw Fault(fmt::format("what is kept here has {} kB at most", most >> 10u));
  const std::lock_guard lock(desk.mutex);
  desk.store.keep_layout(path, layout);
  return Json::object();
}

}  // namespace

void add_state_calls(Calls& calls, Desk& desk) {
  constexpr std::size_t most_of_file = 256u << 10u, most_of_user = 16u << 10u;
  const std::string file = desk.files.path(0), user;
  calls["state.get"] = {[&desk, file](int, const Arguments&) { return get(desk, file); }};
  calls["user.get"] = {[&desk, user](int, const Arguments&) { return get(desk, user); }};
  calls["state.put"] = {
      [&desk, file](int, const Arguments& it) { return put(desk, file, most_of_file, it); }};
  calls["user.put"] = {[&desk, user](int, const Arguments& it) { return put(desk, user, most_of_user, it); }};
}

}  // namespace stepwire::studio
