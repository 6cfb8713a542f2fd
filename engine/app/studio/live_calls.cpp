#include <set>

#include "engine/app/studio/calls.hpp"
#include "engine/app/studio/live/live_run.hpp"
#include "engine/app/studio/live/pointer.hpp"
#include "engine/app/studio/named_faults.hpp"

namespace stepwire::studio {

namespace {

/// Those that take long; all others must act on the run at once.
const std::set<std::string>& slow_calls() {
  static const std::set<std::string> names{"run.load", "figures", "claims", "fan", "profile", "data.export"};
  return names;
}

}  // namespace

void add_live_calls(Calls& calls, live::LiveRun& run) {
  for (const std::string& name : live::LiveRun::call_names())
    calls[name] = {
        [&run, name](int page, const Arguments& arguments) { return run.call(page, name, arguments.all()); },
        slow_calls().contains(name) ? CallRow::Where::slow : CallRow::Where::run};
}

session::LoadedModel edited_model(Desk& desk, int file) {
  return with_names(desk, [&] {
    diagram::Loader loader(desk.registry);
    const std::string path = add_documents(desk, file, loader);
    return live::load_for_page(loader, path);
  });
}

}  // namespace stepwire::studio
