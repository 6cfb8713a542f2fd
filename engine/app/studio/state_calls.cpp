#include "engine/app/studio/calls.hpp"

namespace stepwire::studio {

using json::Json;

namespace {

Json get(Desk& desk) {
  const std::lock_guard lock(desk.mutex);
  const std::string layout = desk.store.layout(desk.files.path(0));
  return Json::object().set("state", layout.empty() ? Json() : Json::parse(layout));
}

Json put(Desk& desk, const Arguments& arguments) {
  constexpr std::size_t most = 256u << 10u;
  const std::string layout = arguments.any("state").text(-1);
  if (layout.size() > most) throw Fault("what is kept of a page has 256 kB at most");
  const std::lock_guard lock(desk.mutex);
  desk.store.keep_layout(desk.files.path(0), layout);
  return Json::object();
}

}  // namespace

void add_state_calls(Calls& calls, Desk& desk) {
  calls["state.get"] = {[&desk](int, const Arguments&) { return get(desk); }};
  calls["state.put"] = {[&desk](int, const Arguments& arguments) { return put(desk, arguments); }};
}

}  // namespace stepwire::studio
