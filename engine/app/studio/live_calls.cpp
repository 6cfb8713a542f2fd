#include <set>

#include "engine/app/studio/calls.hpp"
#include "engine/app/studio/live/live_run.hpp"
#include "engine/app/studio/live/pointer.hpp"
#include "engine/app/studio/named_faults.hpp"

namespace stepwire::studio {

namespace {

/// Returns the names of calls that take long; all others act on the run without delay.
const std::set<std::string>& slow_calls() {
  static const std::set<std::string> names{"run.load", "figures",     "claims",  "fan",
                                           "profile",  "data.export", "run.keep"};
  return names;
}

}  // namespace

void add_live_calls(Calls& calls, live::LiveRun& run) {
  for (const std::string& name : live::LiveRun::call_names())
    calls[name] = {
        [&run, name](int page, const Arguments& arguments) { return run.call(page, name, arguments.all()); },
        slow_calls().contains(name) ? CallRow::Where::slow : CallRow::Where::run};
}

live::Loading edited_model(Desk& desk, int file, bool hand) {
  return with_names(desk, [&] {
    const auto loader = std::make_shared<diagram::Loader>(desk.registry);
    const std::string path = add_documents(desk, file, *loader);
    session::LoadedModel model =
        hand ? live::load_for_page(*loader, path) : session::load_model(*loader, path, {});
    const auto again = [loader, path](const session::LoadOptions& options) {
      return session::load_model(*loader, path, options);  // with the texts of the page
    };
    const auto document = [loader](const std::string& file) -> const yaml::Document& {
      return loader->document(file);
    };
    return live::Loading(std::move(model), again, document);
  });
}

}  // namespace stepwire::studio
