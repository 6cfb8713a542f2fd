#include "engine/app/simulink/ambiguities.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <utility>

#include "engine/app/simulink/flat_model.hpp"
#include "engine/app/simulink/plain_text.hpp"

namespace stepwire::simulink {
namespace {

/// Finder of the places of one system that have two meanings, or none here.
class Finder {
 public:
  Finder(const Model& model, const System& system, const std::string& path)
      : model_(model), system_(system), path_(path) {}

  std::vector<Note> find() {
    for (const Block& block : system_.blocks) sids_.insert(block.sid);
    for (const Block& block : system_.blocks) {
      if (text_of(model_, block, "Commented", "off") == "on") continue;
      find_equal_sid(block);
      if (block.type == "Inport" || block.type == "Outport") {
        find_port(block);
        find_sample_time(block, "SampleTime");
      } else if (text_of(model_, block, "TreatAsAtomicUnit", "off") == "on") {
        find_sample_time(block, "SystemSampleTime");
      }
      if (block.type == "EnablePort" || block.type == "TriggerPort" || block.type == "ActionPort")
        if (const Block* first = first_of(block.type, block))
          report(block, fmt::format("is a second {}; '{}' counts alone", block.type, first->name));
    }
    for (const Line& line : system_.lines) {
      find_second_lines(line);
      find_loose_ends(line);
    }
    return std::move(notes_);
  }

 private:
  void report(const Block& block, const std::string& sentence) {
    notes_.push_back({NoteKind::fault, path_ + block.name, sentence});
  }

  /// Returns the block that had a key before, and makes this block the first where there is none.
  const Block* first_of(const std::string& key, const Block& block) {
    const auto [found, is_new] = first_.emplace(key, &block);
    return is_new ? nullptr : found->second;
  }

  void find_equal_sid(const Block& block) {
    const Block* first = first_of("sid " + block.sid, block);
    if (!first) return;
    const bool is_name = block.sid.starts_with("name ");
    report(block, fmt::format("has {} of '{}' as well; lines lead to that one alone",
                              is_name ? "the name" : "the SID " + block.sid, first->name));
  }

  void find_port(const Block& block) {
    const std::string text = on_one_line(text_of(model_, block, "Port", "1"));
    const int number = port_number(model_, block);
    if (text != std::to_string(number))
      report(block, fmt::format("has the port number '{}'; {} is written", text.substr(0, 40), number));
    if (static_cast<std::size_t>(number) > system_.blocks.size())
      report(block, fmt::format("has the port number {}, and its system has {} blocks", number,
                                system_.blocks.size()));
    if (text_of(model_, block, "IsBusElementPort", "off") == "on" ||
        text_of(model_, block, "IsComposite", "off") == "on")
      report(block, "is the port of an element of a bus; the whole signal of the port is written");
    else if (const Block* first = first_of(fmt::format("{} {}", block.type, number), block))
      report(block, fmt::format(
                        "has the port number {} of '{}' as well; {}", number, first->name,
                        block.type == "Inport" ? "both get the signal of that port" : "that one is written"));
  }

  /// Blocks without a sample time of their own take that of what they read, and not that of the system or of
  /// its ports.
  void find_sample_time(const Block& block, const char* parameter) {
    const std::string time = on_one_line(text_of(model_, block, parameter, "-1"));
    if (time == "-1" || time == "0" || time == "inf") return;
    notes_.push_back(
        {NoteKind::deviates, path_ + block.name,
         fmt::format("has the sample time {}, which is not translated; give `every` to the blocks "
                     "that run at it",
                     time)});
  }

  void find_loose_ends(const Line& line) {
    for (const LineEnd& sink : line.sinks)
      if (!sids_.contains(sink.sid) && !sink.sid.starts_with("name "))
        notes_.push_back({NoteKind::fault, path_ + name_of(line.source.sid),
                          fmt::format("has a line to a block with the SID {}, which the system lacks; it is "
                                      "left out",
                                      sink.sid)});
  }

  void find_second_lines(const Line& line) {
    for (const LineEnd& sink : line.sinks)
      if (const auto [found, is_new] = lines_.emplace(std::pair(sink.sid, sink.port), &line); !is_new)
        notes_.push_back({NoteKind::fault, path_ + name_of(sink.sid),
                          fmt::format("has two lines to its port {}; the last one is written", sink.port)});
  }

  std::string name_of(const std::string& sid) const {
    const auto found = first_.find("sid " + sid);
    return found != first_.end() ? found->second->name : sid.starts_with("name ") ? sid.substr(5) : sid;
  }

  const Model& model_;
  const System& system_;
  const std::string& path_;
  std::map<std::string, const Block*> first_;
  std::set<std::string> sids_;
  std::map<std::pair<std::string, std::string>, const Line*> lines_;
  std::vector<Note> notes_;
};

}  // namespace

std::vector<Note> ambiguities_of(const Model& model, const System& system, const std::string& path) {
  return Finder(model, system, path).find();
}

}  // namespace stepwire::simulink
