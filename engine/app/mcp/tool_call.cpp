#include "engine/app/mcp/tool_call.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <utility>

#include "engine/app/mcp/bounded.hpp"
#include "engine/app/mcp/recorded_signals.hpp"
#include "engine/app/mcp/tool_arguments.hpp"
#include "engine/app/mcp/tool_folder.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/inside.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/table/table_file.hpp"

namespace stepwire::mcp {

using json::Json;
using subprocess::ProcessResult;

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_output = std::size_t{256} << 20;
constexpr std::size_t most_lines = 40;
constexpr std::size_t most_files = 100;

std::string meaning_of(int code) {
  switch (code) {
    case 0:
      return "done";
    case 1:
      return "a claim fails, a search has not converged, two diagrams differ, or an import is not complete";
    case 2:
      return "the diagram or the call is wrong";
    case 3:
      return "something around the program is missing or full";
    default:
      return "ended early";
  }
}

std::string meaning_of(const ProcessResult& done, const VerbCall& call) {
  switch (done.end) {
    case ProcessResult::End::exited:
      return meaning_of(done.status);
    case ProcessResult::End::overdue:
      return fmt::format("ended after {} s, the limit of this call; a larger 'limit' allows more",
                         static_cast<double>(call.limit.count()) / 1000.0);
    case ProcessResult::End::too_much:
      return "ended, since its output is too large; write it with 'out'";
    case ProcessResult::End::stopped:
      return "cancelled";
    case ProcessResult::End::not_started:
      return "the program could not be started";
    default:
      return "ended by a signal, as without memory";
  }
}

Json lines_of(const std::string& text) {
  Json lines = Json::list();
  std::istringstream stream(text);
  std::size_t count = 0;
  for (std::string line; std::getline(stream, line);)
    if (!line.empty() && ++count <= most_lines) lines.push(line);
  if (count > most_lines) lines.push(fmt::format("and {} lines more", count - most_lines));
  return lines;
}

Json files_in(const fs::path& folder, const std::string& out) {
  Json files = Json::list();
  if (!fs::is_directory(folder / out)) return files.push(out);
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder / out))
    if (entry.is_regular_file()) names.push_back(fs::relative(entry.path(), folder).string());
  std::ranges::sort(names);
  for (std::size_t i = 0; i < std::min(names.size(), most_files); ++i) files.push(names[i]);
  if (names.size() > most_files) files.push(fmt::format("and {} more", names.size() - most_files));
  return files;
}

/// Returns the claims of each file alone.
Json claims_of(const Json& runs) {
  Json all = Json::list();
  for (const Json& run : runs.items()) {
    Json one = Json::object();
    for (const char* key : {"file", "claims", "faults", "interrupted"})
      if (const Json* value = run.find(key)) one.set(key, *value);
    all.push(std::move(one));
  }
  return all;
}

void append_claims(const Json& result, std::string& text) {
  for (const Json& run : result.items()) {
    const Json* const claims = run.find("claims");
    for (const Json& claim : claims ? claims->items() : std::span<const Json>()) {
      const Json *that = claim.find("that"), *check = claim.find("check"), *value = claim.find("value"),
                 *holds = claim.find("holds");
      if (!that || !check || !value || !holds) continue;
      text += fmt::format("\n{}: {} ({}; value {})", holds->as_flag().value_or(false) ? "holds" : "FAILS",
                          that->as_text() ? *that->as_text() : "", check->as_text() ? *check->as_text() : "",
                          value->text(-1));
    }
  }
}

/// Adds the output of the verb to the data: as JSON, or else as text.
void add_output(const Tool& tool, const VerbCall& call, const std::string& output, Json& data) {
  if (output.empty()) return;
  if (call.words.back() == "--json" || std::ranges::count(call.words, "--json") > 0) {
    try {
      Json result = Json::parse(output);
      data.set("result", tool.name == "claims" ? claims_of(result) : std::move(result));
      return;
    } catch (const json::JsonError&) {  // a page, as of a search
    }
  }
  data.set("text", output);
}

Json content(const std::string& text) {
  return Json::object().set("type", "text").set("text", text);
}

Json answer(const std::string& text, Json data, bool is_error) {
  Json all = Json::list({content(text)});
  if (!data.find("text")) all.push(content(data.text(-1)));
  return Json::object()
      .set("content", std::move(all))
      .set("structuredContent", std::move(data))
      .set("isError", is_error);
}

Json refused(const std::string& why) {
  return answer(why, Json::object().set("exit", 2).set("meaning", why), true);
}

/// Returns the short text: the outcome, claims, notes, or the page of a verb without data.
std::string short_text(const Json& data) {
  if (const Json* page = data.find("text")) return page->as_text() ? *page->as_text() : "";
  const Json* const meaning = data.find("meaning");
  std::string text = meaning && meaning->as_text() ? *meaning->as_text() : "";
  if (const Json* result = data.find("result")) append_claims(*result, text);
  for (const char* key : {"notes", "shortened"})
    if (const Json* lines = data.find(key))
      for (const Json& line : lines->items()) text += "\n" + (line.as_text() ? *line.as_text() : "");
  return text;
}

Json result_of(const Tool& tool, const VerbCall& call, const ToolFolder& folder, const ProcessResult& done) {
  const bool exited = done.end == ProcessResult::End::exited;
  const bool is_error = !exited || done.status > 1;
  Json data = Json::object();
  if (exited) add_output(tool, call, folder.shown(done.output), data);
  const std::string csv = folder.scratch() + "/signals.csv";
  if (call.rows > 0 && fs::exists(csv)) data.set("signals", recorded_signals(csv, call.rows));
  if (!call.out.empty() && fs::exists(fs::path(folder.path()) / call.out))
    data.set("files", files_in(folder.path(), call.out));
  std::vector<std::string> shortened;
  data = bounded(data, most_bytes, shortened);
  Json whole = Json::object().set("exit", exited ? done.status : -1).set("meaning", meaning_of(done, call));
  for (const auto& [key, value] : data.members()) whole.set(key, value);
  if (!done.errors.empty()) whole.set("notes", lines_of(folder.shown(done.errors)));
  if (!shortened.empty()) whole.set("shortened", Json::list_of(shortened));
  const std::string text = short_text(whole);
  return answer(text, std::move(whole), is_error);
}

}  // namespace

Json call_tool(const Tool& tool, const Json& arguments, const Host& host, std::stop_token stop) {
  try {
    ToolFolder folder(arguments.find("folder"), host.root);
    const VerbCall call = verb_call(tool, arguments, folder);
    subprocess::ProcessCall process{
        .command = {host.program},
        .folder = folder.path(),
        .variables = {std::string(io::inside_variable) + "=" + folder.readable(), "NO_COLOR=1"},
        .stop = std::move(stop),
        .limit = call.limit,
        .max_output = most_output};
    process.command.insert(process.command.end(), call.words.begin(), call.words.end());
    return result_of(tool, call, folder, subprocess::run_process(process));
  } catch (const CallFault& fault) {
    return refused(fault.what());
  } catch (const io::EnvironmentError& error) {
    return refused(error.what());
  } catch (const table::TableError& error) {
    return refused(error.what());
  }
}

}  // namespace stepwire::mcp
