#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <memory>

#include "engine/app/cli/run_call.hpp"
#include "engine/app/cli/verb.hpp"

namespace stepwire::cli {

namespace {

/// Parses a share such as "2/3". Throws CLI::ValidationError.
session::Share share_of(const std::string& text) {
  session::Share share;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, share.number);
  const bool parted = number.ec == std::errc{} && number.ptr != end && *number.ptr == '/';
  const auto count = parted ? std::from_chars(number.ptr + 1, end, share.count) : number;
  if (!parted || count.ec != std::errc{} || count.ptr != end || share.number < 1 ||
      share.number > share.count)
    throw CLI::ValidationError("--part",
                               fmt::format("is K/N, the share K of N from 1/N to N/N, not '{}'", text));
  return share;
}

Action declare_run(CLI::App& verb) {
  const auto call = std::make_shared<RunCall>();
  add_run_options(verb, *call,
                  "folder for signals.csv, signals.mat, pictures, claims.json, run.json, diagram.yaml");
  verb.add_option("--csv", call->csv,
                  "file for the recorded signals as one CSV table; - is the standard output")
      ->type_name("FILE");
  verb.add_option("--junit", call->junit, "file for the claims as test cases, in the XML that servers read")
      ->type_name("FILE");
  verb.add_flag("--profile", call->profile,
                "measure what each block costs; with --out also in profile.csv and profile.svg");
  verb.add_flag("--coverage", call->coverage,
                "list the branches of conditions that no run takes; with --out also in coverage.json");
  add_device_option(verb, call->device);
  verb.add_option("--threads", call->models.threads, "how many threads run a sweep; all cores without it");
  verb.add_option_function<std::string>(
          "--part", [call](const std::string& text) { call->part = share_of(text); },
          "run only this share of a sweep's points, and keep them in --out for 'collect'")
      ->option_text("K/N");
  return [call](const Registry& registry) { return run_models(*call, registry); };
}

}  // namespace

Verb run_verb() {
  return {"run", "run diagram files, judge their claims",
          "Example:\n  stepwire run lag.yaml --set tau=0.2s --stop 2s --out out/lag\n  stepwire run lag.yaml "
          "--csv - | head -3",
          declare_run};
}

}  // namespace stepwire::cli
