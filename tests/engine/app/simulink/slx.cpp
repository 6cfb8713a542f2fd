#include "tests/engine/app/simulink/slx.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "blocks/register.hpp"
#include "engine/base/io/file.hpp"
#include "engine/simulate/run/run.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::simulink {

namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

std::string texts(const P& parameters) {
  std::string text;
  for (const auto& [name, value] : parameters)
    text += fmt::format("<P Name=\"{}\">{}</P>\n", name, escaped(value));
  return text;
}

const Registry& registry() {
  static const Registry all = blocks();
  return all;
}

run::RunResult run_file(const std::string& file) {
  diagram::Loader loader(registry());
  const plan::Plan plan = plan::make_plan(loader.load(file));
  return run::run_plan(plan);
}

std::string path_of_archive(const Scratch& folder, const testing::Entries& entries) {
  return testing::write_zip(folder.path("model.slx"), entries);
}

}  // namespace

std::string block(const std::string& type, const std::string& name, int sid, const P& parameters,
                  const std::string& inner) {
  return fmt::format(
      "<Block BlockType=\"{}\" Name=\"{}\" SID=\"{}\">\n<P Name=\"Position\">[10, 10, 40, "
      "40]</P>\n{}{}</Block>\n",
      type, escaped(name), sid, texts(parameters), inner);
}

std::string reference(const std::string& source, const std::string& name, int sid, const P& parameters) {
  return fmt::format(
      "<Block BlockType=\"Reference\" Name=\"{}\" SID=\"{}\">\n<P "
      "Name=\"SourceBlock\">{}</P>\n<InstanceData>{}</InstanceData></Block>\n",
      escaped(name), sid, escaped(source), texts(parameters));
}

std::string line(const std::string& from, const std::vector<std::string>& to, const std::string& name) {
  std::string text = "<Line>\n" + (name.empty() ? "" : texts({{"Name", name}})) + texts({{"Src", from}});
  if (to.size() == 1) return text + texts({{"Dst", to[0]}}) + "</Line>\n";
  for (const std::string& one : to) text += "<Branch>\n" + texts({{"Dst", one}}) + "</Branch>\n";
  return text + "</Line>\n";
}

testing::Entries entries_of(const ModelText& model) {
  const std::string head = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n";
  const std::string defaults = "<BlockParameterDefaults>" + model.defaults + "</BlockParameterDefaults>";
  const std::string solver =
      "<Object ObjectID=\"2\" ClassName=\"Simulink.SolverCC\">" + texts(model.solver) + "</Object>" +
      "<Object ObjectID=\"3\" ClassName=\"Simulink.DataIOCC\">" + texts(model.states) + "</Object>" +
      "<Object ObjectID=\"5\" ClassName=\"Simulink.DebuggingCC\">" + texts(model.messages) + "</Object>";
  const std::string system = "<System>" + model.system + "</System>";
  const std::string body =
      texts(model.callbacks) +
      (model.is_new ? "<System Ref=\"system_root\"/>"
                    : defaults + "<Array PropName=\"ConfigurationSets\">" + solver + "</Array>" + system);
  testing::Entries entries{
      {"[Content_Types].xml", head + "<Types/>"},
      {"simulink/blockdiagram.xml",
       head + "<ModelInformation Version=\"1.0\">\n<Model>" + body + "</Model>\n</ModelInformation>"}};
  if (!model.is_new) return entries;
  entries["simulink/systems/system_root.xml"] = head + system;
  entries["simulink/bddefaults.xml"] = head + defaults;
  entries["simulink/configSet0.xml"] =
      head + "<ConfigSet><Object ClassName=\"Simulink.ConfigSet\"><Array PropName=\"Components\">" + solver +
      "</Array></Object></ConfigSet>";
  return entries;
}

Imported::Imported(const ModelText& model) : Imported(entries_of(model)) {}

Imported::Imported(const testing::Entries& entries) {
  result = import_model({path_of_archive(folder, entries), folder.path("model.yaml")}, registry());
}

std::string Imported::text() const {
  return io::read_file(folder.path("model.yaml"));
}

std::string Imported::part(const std::string& file) const {
  return io::read_file(folder.path("model-parts/" + file));
}

table::Table Imported::run() const {
  INFO(text());
  for (const Note& note : result.notes)
    UNSCOPED_INFO(word_of(note.kind) << " " << note.block << ": " << note.sentence);
  run::RunResult done = run_file(folder.path("model.yaml"));
  for (const run::RunFault& fault : done.faults) FAIL(fault.fault.text());
  REQUIRE(!done.recordings.empty());
  return std::move(done.recordings.front().table);
}

std::string Imported::fault() const {
  const run::RunResult done = run_file(folder.path("model.yaml"));
  return done.faults.empty() ? "" : done.faults.front().fault.text();
}

double Imported::last(const std::string& name) const {
  const table::Table table = run();
  INFO(text());
  return column(table, name).back();
}

std::string Imported::notes(NoteKind kind) const {
  std::string text;
  for (const Note& note : result.notes)
    if (note.kind == kind) text += note.block + ": " + note.sentence + "\n";
  return text;
}

double from_source(const std::string& source, const std::string& stop) {
  ModelText model{source + block("ToWorkspace", "To Workspace", 2, {{"VariableName", "y"}}) +
                  line("1#out:1", {"2#in:1"})};
  model.solver["StopTime"] = stop;
  return Imported(model).last("y");
}

double through(const std::string& block_text, const std::vector<std::string>& sources,
               const std::string& stop, int port) {
  std::string system = block_text + block("ToWorkspace", "To Workspace", 10, {{"VariableName", "y"}});
  for (std::size_t i = 1; i <= sources.size(); ++i)
    system += sources[i - 1] + line(fmt::format("{}#out:1", i), {fmt::format("9#in:{}", i)});
  ModelText model{system + line(fmt::format("9#out:{}", port), {"10#in:1"})};
  model.solver["StopTime"] = stop;
  return Imported(model).last("y");
}

std::string number(int sid, const std::string& value) {
  return block("Constant", fmt::format("Constant{}", sid), sid, {{"Value", value}});
}

std::string time_source(int sid) {
  return block("Clock", fmt::format("Clock{}", sid), sid);
}

}  // namespace stepwire::simulink
