// Sinks of Simulink: records, and conditions that end a run.
#include <fmt/format.h>

#include "engine/app/simulink/forms.hpp"
#include "engine/app/simulink/plain_text.hpp"

namespace stepwire::simulink {
namespace {

void record_inputs(BlockWriter& write, const std::string& name, const std::string& scope) {
  for (int i = 1; i <= write.inputs(); ++i)
    if (write.is_connected(i))
      write.collected().recorded.push_back({&write.unit(), write.source(i), i == 1 ? name : "", scope});
}

void scope(BlockWriter& write) {
  record_inputs(write, "", write.name());
}

void display(BlockWriter& write) {
  record_inputs(write, "", "");
}

void to_workspace(BlockWriter& write) {
  record_inputs(write, valid_name(write.text("VariableName", "simout")), "");
  const SampleTime time = write.sample_time();
  if (time.kind == SampleTime::Kind::discrete)
    write.note("is recorded at each step, and not with its own sample time");
  write.ignore("Decimation", "1");
}

void to_file(BlockWriter& write) {
  record_inputs(write, "", "");
  write.note("its signal is recorded with all others: run --out writes them");
}

void terminator(BlockWriter&) {}

void stop(BlockWriter& write) {
  if (write.unit().parent) throw Untranslated("it ends the run within a subsystem that runs on condition");
  write.collected().stops.push_back(write.source() + " != 0");
}

void assertion(BlockWriter& write) {
  if (!write.is_on("Enabled", "on")) return write.note("is not enabled, and left out");
  if (!write.is_on("StopWhenAssertionFail", "on"))
    return write.note("warns only, and is left out; write a claim");
  write.ignore("AssertionFailFcn", "");
  write.make("Assert").u();
}

}  // namespace

std::vector<Translation> sink_translations() {
  return {{"Scope", "`record` and a `figure`", scope},
          {"Floating Scope", "`record`", display},
          {"XY Graph", "`record`", display},
          {"Display", "`record`", display},
          {"ToWorkspace", "`record` under the variable's name", to_workspace},
          {"ToFile", "`record`", to_file},
          {"Terminator", "nothing: an output may be unused", terminator},
          {"Stop", "`stop_when`", stop},
          {"Assertion", "`Assert`", assertion}};
}

}  // namespace stepwire::simulink
