#include "engine/simulate/codegen/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "engine/base/text/characters.hpp"

namespace stepwire::codegen {

namespace {

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

void part(std::string& text, std::string_view word, const std::string& parted) {
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += parted.size())
    text.replace(at, word.size(), parted);
}

std::string line_of(const plan::Plan& plan, const diagram::Origin& origin) {
  const yaml::Place place = plan.diagram.place(origin);
  return fmt::format("{}:{}", std::filesystem::path(place.file).filename().string(), place.mark.line);
}

}  // namespace

std::string cpp_comment(std::string_view text) {
  std::string result = text::visible(text);
  part(result, "?\?/", "? ?/");  // trigraph of a backslash
  part(result, "*/", "* /");
  part(result, "/*", "/ *");
  result.erase(result.find_last_not_of(' ') + 1);
  return result.ends_with('\\') ? result + "." : result;
}

std::string cpp_identifier(std::string_view name) {
  std::string result;
  for (const char c : name) result += is_letter(c) || is_digit(c) ? c : '_';
  const bool begins_well = !result.empty() && !is_digit(result.front());
  return begins_well ? result : "_" + result;
}

std::string free_member(std::string_view name, std::set<std::string>& taken) {
  const std::string first = cpp_identifier(name) + "_";
  std::string own = first;
  for (int number = 2; !taken.insert(own).second; ++number) own = fmt::format("{}{}_", first, number);
  return own;
}

std::string cpp_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    // An octal escape has at most three digits, whereas a hexadecimal one has no limit.
    const bool plain = is_letter(c) || is_digit(c) ||
                       std::string_view(" !#$%&'()*+,-./:;<=>@[]^_`{|}~").find(c) != std::string_view::npos;
    result += plain ? std::string(1, c) : fmt::format("\\{:03o}", static_cast<unsigned char>(c));
  }
  return result + '"';
}

std::string comment_of(const plan::Plan& plan, std::size_t block) {
  const diagram::DiagramBlock& from = plan.diagram.blocks[block];
  return cpp_comment(fmt::format("{}: {}, {}", from.name, from.type().name, line_of(plan, from.origin)));
}

PlaceNames::PlaceNames(const plan::Plan& plan) {
  for (const diagram::DiagramBlock& block : plan.diagram.blocks)
    blocks_.push_back(free(cpp_identifier(block.name)));
  taken_.clear();  // names of places are a member's name after that of their block
  places_.push_back({plan::Layout::time, 1, "time", "of the evaluation [s]"});
  places_.push_back({plan::Layout::timed, 1, "timed", "for which `timed` was computed last [s]"});
  for (const NamedPlace& place : places_) {
    by_offset_[place.offset] = 0;
    taken_.insert(place.name);
  }
  for (int block : plan.memory_order) add_block(plan, static_cast<std::size_t>(block));
  for (int block : plan.memory_order) add_constants(plan, static_cast<std::size_t>(block));
  std::sort(places_.begin(), places_.end(),
            [](const NamedPlace& a, const NamedPlace& b) { return a.offset < b.offset; });
  for (std::size_t i = 0; i < places_.size(); ++i) by_offset_[places_[i].offset] = i;
}

/// Returns the name, with a number appended if it is taken.
std::string PlaceNames::free(const std::string& name) {
  std::string own = name;
  for (int number = 2; !taken_.insert(own).second; ++number) own = fmt::format("{}_{}", name, number);
  return own;
}

void PlaceNames::add(const plan::Plan& plan, std::size_t block, const std::string& member,
                     const plan::SignalSlot& slot) {
  if (slot.size == 0 || !by_offset_.emplace(slot.offset, 0).second) return;  // an output may be a state
  const diagram::DiagramBlock& from = plan.diagram.blocks[block];
  places_.push_back({slot.offset, slot.size, free(blocks_[block] + "_" + member),
                     cpp_comment(fmt::format("{}.{}, {}, {}", from.name, member, from.type().name,
                                             line_of(plan, from.origin)))});
}

void PlaceNames::add_block(const plan::Plan& plan, std::size_t block) {
  const BlockType& type = plan.diagram.blocks[block].type();
  const plan::PlannedBlock& planned = plan.blocks[block];
  for (std::size_t s = 0; s < type.states.size(); ++s) {
    add(plan, block, type.states[s].member, planned.states[s]);
    if (type.states[s].continuous && !planned.slope_is_input)
      add(plan, block, type.states[s].member + "_dot", planned.derivatives[s]);
  }
  for (std::size_t o = 0; o < type.outputs.size(); ++o)
    add(plan, block, type.outputs[o].member, planned.outputs[o]);
  for (std::size_t n = 0; n < type.diagnostics.size(); ++n)
    add(plan, block, type.diagnostics[n].member, planned.diagnostics[n]);
}

void PlaceNames::add_constants(const plan::Plan& plan, std::size_t block) {
  const BlockType& type = plan.diagram.blocks[block].type();
  for (std::size_t i = 0; i < type.inputs.size(); ++i)
    for (const plan::SignalSlot& slot : plan.blocks[block].inputs[i])
      if (slot.offset >= plan.layout.constants) add(plan, block, type.inputs[i].member, slot);
}

std::string PlaceNames::at(std::size_t offset) const {
  const auto behind = by_offset_.upper_bound(offset);
  if (behind == by_offset_.begin()) return fmt::format("{}", offset);
  const NamedPlace& place = places_[std::prev(behind)->second];
  if (place.offset == offset) return "at::" + place.name;
  const std::size_t element = offset - place.offset;  // of a signal, for a reference to one element
  const bool inside = element < static_cast<std::size_t>(place.size);
  return inside ? fmt::format("at::{} + {}", place.name, element) : fmt::format("{}", offset);
}

}  // namespace stepwire::codegen
