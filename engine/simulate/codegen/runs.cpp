#include "engine/simulate/codegen/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <span>
#include <utility>

#include "engine/model/diagram/external_input.hpp"
#include "engine/model/plan/plan.hpp"
#include "engine/simulate/codegen/guard_text.hpp"
#include "engine/simulate/codegen/names.hpp"

namespace stepwire::codegen {

namespace {

// Late states as C++: states that updates of a table store until all updates are done (plan::LateStates).

const plan::LateStates& late_of(const plan::Plan& plan, const plan::KernelCall& call) {
  return plan.late[static_cast<std::size_t>(call.late)];
}

bool has_late(const std::vector<plan::KernelCall>& calls) {
  return std::ranges::any_of(calls, [](const plan::KernelCall& call) { return call.late >= 0; });
}

/// Return the statements before and after the calls.
std::string begin_late_text(const plan::Plan& plan, const std::vector<plan::KernelCall>& calls) {
  std::string text;
  for (const plan::KernelCall& call : calls) {
    if (call.late < 0) continue;
    const plan::LateStates& late = late_of(plan, call);
    text += copy_text(late.state, late.before, late.size) + copy_text(late.state, late.after, late.size);
  }
  return text;
}

std::string end_late_text(const plan::Plan& plan, const std::vector<plan::KernelCall>& calls) {
  std::string text;
  for (const plan::KernelCall& call : calls)
    if (call.late >= 0)
      text += copy_text(late_of(plan, call).after, late_of(plan, call).state, late_of(plan, call).size);
  return text;
}

/// Returns the statements after the call of a block with late states.
std::string set_aside_text(const plan::Plan& plan, const plan::KernelCall& call) {
  const plan::LateStates& late = late_of(plan, call);
  return copy_text(late.state, late.after, late.size) + copy_text(late.before, late.state, late.size);
}

/// Returns the type of a column of such numbers; an empty text if `text` is not a number.
std::string type_of_number(const std::string& text) {
  if (text.empty() || text.find_first_not_of("0123456789.e+-u") != std::string::npos) return "";
  if (text.find_first_of(".e") != std::string::npos) return "double";
  return text.back() == 'u' ? "std::uint64_t" : "std::int64_t";
}

/// Loop over k for blocks whose set-ups differ only in the contents of placeholders.
class Loop {
 public:
  Loop(const plan::Plan& plan, const Statements& statements, std::vector<std::size_t> blocks,
       std::vector<Statements::Pieces> set_ups)
      : plan_(plan), statements_(statements), blocks_(std::move(blocks)), set_ups_(std::move(set_ups)) {}

  /// True if the blocks differ in numbers and places only.
  bool possible() const {
    const auto& first = set_ups_.front();
    for (const auto& other : set_ups_) {
      if (other.size() != first.size()) return false;
      for (std::size_t i = 0; i < first.size(); ++i)
        if (!alike(first[i], other[i])) return false;
    }
    return true;
  }

  std::string text(Phase phase) {
    std::string set_up;
    for (std::size_t i = 0; i < set_ups_.front().size(); ++i) {
      const auto& piece = set_ups_.front()[i];
      set_up += piece.before + filling(i) + piece.after;
    }
    std::string text = fmt::format("  // {} of {}: {} to {}\n", blocks_.size(), struct_of(plan_, blocks_[0]),
                                   comment_of(plan_, blocks_.front()), comment_of(plan_, blocks_.back()));
    if (!columns_.empty()) text += table();
    text += fmt::format("  for (int k = 0; k < {}; ++k) {{\n{}  }}\n", blocks_.size(),
                        statements_.call_text(blocks_[0], phase, set_up));
    return columns_.empty() ? text : "  {\n" + text + "  }\n";
  }

 private:
  static bool alike(const Statements::Piece& a, const Statements::Piece& b) {
    if (a.before != b.before || a.after != b.after || (a.offset < 0) != (b.offset < 0)) return false;
    return a.offset >= 0 || a.hole == b.hole ||
           (type_of_number(a.hole) == type_of_number(b.hole) && !type_of_number(a.hole).empty());
  }

  /// Returns the content of a placeholder: constant, place with constant stride, or column of the table.
  std::string filling(std::size_t piece) {
    const auto& first = set_ups_.front()[piece];
    if (first.offset < 0) return all_equal(piece) ? first.hole : column(piece, type_of_number(first.hole));
    const std::int64_t stride = set_ups_[1][piece].offset - first.offset;
    for (std::size_t k = 2; k < set_ups_.size(); ++k)
      if (set_ups_[k][piece].offset - set_ups_[k - 1][piece].offset != stride) return column(piece, "int");
    if (stride == 0) return first.hole;
    return stride == 1 ? first.hole + " + k" : fmt::format("{} + {} * k", first.hole, stride);
  }

  bool all_equal(std::size_t piece) const {
    return std::all_of(set_ups_.begin(), set_ups_.end(), [&](const auto& set_up) {
      return set_up[piece].hole == set_ups_.front()[piece].hole;
    });
  }

  std::string column(std::size_t piece, const std::string& type) {
    columns_.push_back({piece, type});
    return fmt::format("row[k].{}{}", type == "int" ? "place" : "number", columns_.size());
  }

  std::string table() const {
    std::string text = "  static constexpr struct {\n";
    for (std::size_t c = 0; c < columns_.size(); ++c)
      text += fmt::format("    {} {}{};\n", columns_[c].type, columns_[c].type == "int" ? "place" : "number",
                          c + 1);
    text += "  } row[] = {\n";
    for (std::size_t k = 0; k < blocks_.size(); ++k) {
      text += "      {";
      for (std::size_t c = 0; c < columns_.size(); ++c)
        text += (c == 0 ? "" : ", ") + set_ups_[k][columns_[c].piece].hole;
      text += fmt::format("}},  // {}\n", comment_of(plan_, blocks_[k]));
    }
    return text + "  };\n";
  }

  struct Column {
    std::size_t piece;
    std::string type;
  };

  const plan::Plan& plan_;
  const Statements& statements_;
  std::vector<std::size_t> blocks_;
  std::vector<Statements::Pieces> set_ups_;
  std::vector<Column> columns_;
};

using SetUps = std::vector<Statements::Pieces>;

/// True if the step from `one` to `next` equals that from `first` to `second`, apart from fractional numbers.
/// A row of such blocks needs no table of places.
bool goes_on(const Statements::Pieces& first, const Statements::Pieces& second, const Statements::Pieces& one,
             const Statements::Pieces& next) {
  if (first.size() != next.size()) return false;
  for (std::size_t i = 0; i < next.size(); ++i) {
    if (next[i].offset >= 0 && next[i].offset - one[i].offset != second[i].offset - first[i].offset)
      return false;
    const bool fraction = type_of_number(next[i].hole) == "double";
    if (next[i].offset < 0 && !fraction && next[i].hole != one[i].hole) return false;
  }
  return true;
}

/// Returns the number of blocks from `from` on that form a row with constant stride.
std::size_t even_row(const SetUps& set_ups, std::size_t from) {
  std::size_t end = from + 1;
  if (end >= set_ups.size() || set_ups[from].size() != set_ups[end].size()) return 1;
  while (end < set_ups.size() && goes_on(set_ups[from], set_ups[from + 1], set_ups[end - 1], set_ups[end]))
    ++end;
  return end - from;
}

/// Generates the code of one kernel call: rows with constant stride become loops, the others table loops or
/// calls.
class BatchCode {
 public:
  BatchCode(const plan::Plan& plan, const Statements& statements, const std::vector<std::size_t>& blocks,
            Phase phase, const Places& places, Code made)
      : plan_(plan),
        statements_(statements),
        blocks_(blocks),
        phase_(phase),
        places_(places),
        made_(std::move(made)) {}

  void append_to(std::vector<Code>& code) {
    if (blocks_.size() < places_.min_in_loop) return add(0, blocks_.size(), code);
    for (std::size_t block : blocks_) set_ups_.push_back(statements_.set_up(block, places_, true));
    std::size_t left = 0;
    for (std::size_t at = 0; at < blocks_.size();) {
      const std::size_t row = even_row(set_ups_, at);
      if (row >= places_.min_in_loop) {
        add(left, at, code);
        add(at, at + row, code);
        left = at + row;
      }
      at += row;
    }
    add(left, blocks_.size(), code);
  }

 private:
  void add(std::size_t first, std::size_t last, std::vector<Code>& code) const {
    const auto part = [&](const auto& all) {
      return std::vector(all.begin() + static_cast<std::ptrdiff_t>(first),
                         all.begin() + static_cast<std::ptrdiff_t>(last));
    };
    if (last - first >= places_.min_in_loop) {
      Loop loop(plan_, statements_, part(blocks_), part(set_ups_));
      if (loop.possible()) return push(loop.text(phase_), code);
    }
    for (std::size_t i = first; i < last; ++i) push(statements_.call(blocks_[i], phase_, places_), code);
  }

  void push(std::string text, std::vector<Code>& code) const {
    code.push_back(made_);
    code.back().text = std::move(text);
  }

  const plan::Plan& plan_;
  const Statements& statements_;
  const std::vector<std::size_t>& blocks_;
  Phase phase_;
  const Places& places_;
  Code made_;  ///< holds the condition of the call
  SetUps set_ups_;
};

/// Returns the code of the calls in [first, end) of a table, without loop solvers.
std::vector<Code> calls_between(const plan::Plan& plan, const Statements& statements,
                                std::span<const plan::KernelCall> batches, Phase phase,
                                const Places& places) {
  const PlaceNames& names = statements.names();
  std::map<std::size_t, std::size_t> at_memory;
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) at_memory[plan.blocks[b].memory] = b;
  std::vector<Code> code;
  for (const plan::KernelCall& batch : batches) {
    std::vector<std::size_t> blocks;
    const BlockType& type = plan.diagram.blocks[at_memory.at(batch.first)].type();
    for (std::size_t i = 0; i < batch.count; ++i)
      blocks.push_back(at_memory.at(batch.first + i * type.bytes));
    const Code when{"", plan.periods[static_cast<std::size_t>(batch.period)],
                    active_text(names, batch.active)};
    BatchCode(plan, statements, blocks, phase_of(type, batch.run, phase), places, when).append_to(code);
    if (batch.late >= 0) code.back().text += set_aside_text(plan, batch);
    if (batch.guard >= 0)
      code.back().text = guard_call(names, plan, static_cast<std::size_t>(batch.guard), code.back().text);
  }
  return code;
}

/// Returns "tick % 4 == 0 && w[at::pump_active] != 0.0"; an empty text for an unconditional call.
std::string condition_of(const Code& code) {
  std::string text = due_text(code.period);
  if (!code.active.empty()) text += fmt::format("{}{} != 0.0", text.empty() ? "" : " && ", code.active);
  return text;
}

/// Returns the code of an algebraic loop, whose calls are repeated until they converge.
Code loop_code(const plan::Plan& plan, const plan::LoopCall& call, const std::vector<Code>& calls) {
  const plan::SolvedLoop& loop = plan.loops[call.loop];
  const diagram::AlgebraicLoops& options = plan.diagram.algebraic_loops;
  std::string tears, diagnostics;
  Eigen::Index unknowns = 0;
  for (std::size_t t = 0; t < call.tears.size(); ++t) {
    const plan::SignalSlot& tear = call.tears[t];
    tears += fmt::format("{{{}, {}, {}}}, ", tear.offset, tear.size, call.residuals[t]);
    unknowns += tear.size;
  }
  for (const std::size_t place : loop.diagnostics) diagnostics += fmt::format("{}, ", place);
  return {fmt::format(
      "  {{  // {0}\n    static constexpr solve::Tear tears[] = {{{1}}};\n"
      "    static constexpr std::size_t diagnostics[] = {{{2}0}};\n"
      "    static constexpr solve::LoopTask task{{tears, {3}, diagnostics, {4}, {5}, at::time, {6}, {7}}};\n"
      "    solve::LoopSolver<{8}>({8}).solve(task, w, [&] {{\n{9}    }});\n  }}\n",
      cpp_comment(loop.path), tears, diagnostics, call.tears.size(), loop.diagnostics.size(), loop.report,
      number_text(options.tolerance), options.max_iterations, unknowns,
      with_conditions(calls, 0, calls.size()))};
}

}  // namespace

std::string with_conditions(const std::vector<Code>& code, std::size_t first, std::size_t last) {
  std::string text, condition;
  for (std::size_t i = first; i < last; ++i) {
    if (std::string own = condition_of(code[i]); own != condition) {
      if (!condition.empty()) text += "  }\n";
      condition = std::move(own);
      if (!condition.empty()) text += fmt::format("  if ({}) {{\n", condition);
    }
    text += code[i].text;
  }
  return condition.empty() ? text : text + "  }\n";
}

std::vector<Code> calls_of(const plan::Plan& plan, const Statements& statements,
                           const std::vector<plan::KernelCall>& batches, Phase phase, const Places& places) {
  std::vector<Code> code;
  const auto between = [&](std::size_t first, std::size_t end) {
    return calls_between(plan, statements, std::span(batches).subspan(first, end - first), phase, places);
  };
  if (has_late(batches)) code.push_back({begin_late_text(plan, batches)});
  std::size_t next = 0;
  for (const plan::LoopCall& loop : plan.loops_of(batches)) {
    std::ranges::move(between(next, loop.first), std::back_inserter(code));
    code.push_back(loop_code(plan, loop, between(loop.first, loop.end)));
    next = loop.end;
  }
  std::ranges::move(between(next, batches.size()), std::back_inserter(code));
  if (has_late(batches)) code.push_back({end_late_text(plan, batches)});
  return code;
}

std::vector<Code> starts_of(const plan::Plan& plan, const Statements& statements, const Places& places,
                            const std::vector<int>& of) {
  std::vector<Code> code;
  std::vector<std::size_t> blocks;
  const auto type_of = [&](std::size_t block) { return &plan.diagram.blocks[block].type(); };
  const auto flush = [&] {
    if (!blocks.empty()) BatchCode(plan, statements, blocks, Phase::start, places, {}).append_to(code);
    blocks.clear();
  };
  for (const int index : of) {
    const auto b = static_cast<std::size_t>(index);
    if (!blocks.empty() && type_of(blocks.front()) != type_of(b)) flush();
    if (type_of(b)->start && type_of(b) != &diagram::external_input_type()) blocks.push_back(b);
  }
  flush();
  return code;
}

}  // namespace stepwire::codegen
