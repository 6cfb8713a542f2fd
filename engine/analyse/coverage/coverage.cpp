#include "engine/analyse/coverage/coverage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "engine/analyse/coverage/chart_states.hpp"
#include "engine/analyse/coverage/table_regions.hpp"
#include "engine/base/expression/margin.hpp"
#include "engine/model/plan/active.hpp"

namespace stepwire::coverage {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
/// Bits of a number that no crossing function writes.
constexpr std::uint64_t unwritten = 0x7ff8'dead'beef'0001;

/// Address of the block that a call of the plan gets; a kernel has no context of its own.
thread_local const void* called = nullptr;

/// Returns the address of a block of a run.
const void* address_of(run::Executor& simulation, std::size_t block) {
  const std::size_t first = simulation.plan().blocks[block].memory;
  simulation.call({[](void* at, void*) { called = at; }, first, first, 1, 0});
  return called;
}

/// Returns the elements of all ports and states of a block, a bound of its crossing functions.
std::size_t room_for_crossings(const plan::PlannedBlock& block, const BlockType& type) {
  constexpr std::size_t transitions = 4096;
  std::size_t elements = 1;
  for (const auto* slots : {&block.outputs, &block.states})
    for (const plan::SignalSlot& slot : *slots) elements += static_cast<std::size_t>(slot.size);
  for (const auto& input : block.inputs)
    for (const plan::SignalSlot& slot : input) elements += static_cast<std::size_t>(slot.size);
  return transitions + 2 * elements * (type.crossings.size() + 1);
}

/// Returns the declared crossings that the block has numbers for.
std::vector<std::string> docs_of(const plan::PlannedBlock& block, const BlockType& type) {
  std::vector<std::string> docs;
  for (const CrossingSpec& spec : type.crossings) {
    const bool connected = !spec.inputs.empty() &&
                           !block.inputs[static_cast<std::size_t>(type.input(spec.inputs.front()))].empty();
    if (!spec.if_connected || connected) docs.push_back(spec.doc);
  }
  return docs;
}

/// Returns the text or word of a parameter; empty for a type without it.
std::string text_of(const diagram::DiagramBlock& block, const char* parameter) {
  const ParameterSpec* spec = block.type().parameter(parameter);
  if (!spec) return "";
  const Value value = spec->get(block.block.get());
  if (const double* word = std::get_if<double>(&value.content); word && !spec->words.empty())
    return spec->words[static_cast<std::size_t>(*word)];
  return value.text() ? *value.text() : "";
}

/// Returns the branch points of a block's formula, beyond which its functions are constant; std::nullopt for
/// a block without a formula.
std::optional<expression::Branches> branches_of_formula(const diagram::DiagramBlock& block) {
  const std::string text = text_of(block, "expression");
  if (text.empty()) return std::nullopt;
  try {
    return expression::branches_of(expression::Expression(text, [](std::string_view) { return true; }));
  } catch (const expression::ExpressionError&) {
    return std::nullopt;
  }
}

constexpr std::size_t above = 0, below = 1;  // branches of a crossing function
/// Branch of a crossing function that is exactly 0; std::nullopt where 0 is neither branch.
using SideOfZero = std::optional<std::size_t>;

/// Returns the side of a comparison of a block whose function is the left side minus the right one.
SideOfZero side_of(const std::string& relation) {
  if (relation == "greater" || relation == ">" || relation == "less_equal" || relation == "<=") return below;
  if (relation == "less" || relation == "<" || relation == "greater_equal" || relation == ">=") return above;
  return std::nullopt;
}

/// Returns the side of a condition whose function is positive where it is true. Joined conditions of both
/// kinds have none, since either one may be at 0.
SideOfZero side_of_condition(const std::string& text) {
  bool holds = false, fails = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool is_equal = text.compare(at + 1, 1, "=") == 0;
    if (text[at] == '!' || (text[at] == '=' && is_equal)) return std::nullopt;
    if (text[at] != '<' && text[at] != '>') continue;
    (is_equal ? holds : fails) = true;
  }
  if (holds == fails) return std::nullopt;
  return holds ? above : below;
}

/// Returns the sides of a block's functions at 0: of a signal that is true or false, false. A bend, such as
/// that of Abs, has none: both sides agree.
std::vector<SideOfZero> sides_of_zero(const diagram::DiagramBlock& block,
                                      const std::vector<std::string>& docs, std::size_t count) {
  if (const auto formula = branches_of_formula(block)) {
    std::vector<SideOfZero> sides;
    const std::size_t points = std::max<std::size_t>(1, formula->texts.size());
    for (std::size_t k = 0; k < count; ++k)  // declaration by declaration, each with all elements
      sides.push_back(side_of_condition(formula->texts.empty() ? "" : formula->texts[k * points / count]));
    return sides;
  }
  for (const char* relation : {"operator", "criterion"})
    if (const std::string text = text_of(block, relation); !text.empty())
      return std::vector<SideOfZero>(count, side_of(text));
  std::vector<SideOfZero> sides(count);
  for (std::size_t k = 0; k < count; ++k)
    if (docs[k * docs.size() / count].find("becomes true or false") != std::string::npos) sides[k] = below;
  return sides;
}

/// Limits of a number: parameters, and the name of the state, empty for the first output.
struct LimitNames {
  const char *lower, *upper, *state, *what;
};
constexpr LimitNames limit_names[] = {{"lower", "upper", "", "the output"},
                                      {"integral_lower", "integral_upper", "integral", "the integral"}};

/// Returns the element of a parameter that has one number, or one for each element; infinite without it.
double element_of(const diagram::DiagramBlock& block, const char* parameter, std::size_t element) {
  const Value value = block.type().parameter(parameter)->get(block.block.get());
  if (const double* number = std::get_if<double>(&value.content)) return *number;
  const auto* numbers = std::get_if<Eigen::VectorXd>(&value.content);
  if (!numbers || numbers->size() == 0) return std::numeric_limits<double>::infinity();
  const auto size = static_cast<std::size_t>(numbers->size());
  return (*numbers)[static_cast<Eigen::Index>(std::min(element, size - 1))];
}

/// Names the crossing functions of a block. The order of several declarations with several elements each is
/// that of the block, so a name then has the number of the function and all of them.
std::vector<std::string> names_of(const std::vector<std::string>& docs, std::size_t count) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < count; ++k) {
    if (docs.size() == count)
      names.push_back(docs[k]);
    else if (docs.size() == 1)
      names.push_back(fmt::format("{} ({})", docs.front(), k + 1));
    else
      names.push_back(fmt::format("crossing {} of {}: {}", k + 1, count, fmt::join(docs, ", or ")));
  }
  return names;
}

}  // namespace

/// Coverage of one run.
class CoverageObserver::OfRun : run::SideObserver {
 public:
  explicit OfRun(run::Executor& simulation) : plan_(simulation.plan()) {
    for (std::size_t block = 0; block < plan_.blocks.size(); ++block) add_block(simulation, block);
    simulation.show_events(this);
  }

  /// Counts the blocks that are computed at a tick. Between its own ticks a sampled block reads nothing.
  void evaluate(const double* values, std::int64_t tick) {
    const auto is_due = [&](const auto& one) { return tick % one.rate.ticks == one.rate.first; };
    for (Crossings& one : crossings_)
      if (is_due(one)) count_crossings(one, values);
    for (const Guard& one : guards_) count_guard(one, values);
    for (Constant& one : constants_)
      if (is_due(one)) count_constant(one, values);
    for (Machine& one : machines_)
      if (is_due(one)) count_machine(one, values);
    for (const Table& one : tables_)
      if (is_due(one)) count_table(one, values);
    for (const Limit& one : limits_)
      if (is_due(one)) count_limit(one, values);
  }

  /// Returns the conditions. A function that is infinite at each tick, as of a limit that is left out, is no
  /// condition.
  Coverage finished() {
    std::vector<bool> absent(coverage_.conditions.size(), false);
    for (const Crossings& one : crossings_)
      for (std::size_t k = 0; k < one.infinite.size(); ++k) {
        const Condition& condition = coverage_.conditions[one.condition + k];
        absent[one.condition + k] = one.infinite[k] > 0 && condition.covered() == 0 && condition.zeros == 0;
      }
    Coverage found;
    for (std::size_t i = 0; i < absent.size(); ++i)
      if (!absent[i]) found.conditions.push_back(coverage_.conditions[i]);
    return found;
  }

 private:
  /// Counts the functions whose crossings are located, at the end of a step that leads beyond one.
  void before_instant(const double* values) override {
    for (Crossings& one : crossings_)
      if (one.is_located) count_crossings(one, values);
  }

  /// Counts the blocks that are computed at events; others keep the outputs of their tick.
  void after_event(const double* values) override {
    before_instant(values);
    for (const Guard& one : guards_) count_guard(one, values);
    const auto is_continuous = [](const auto& one) { return one.rate.kind == plan::Rate::Kind::continuous; };
    for (Constant& one : constants_)
      if (is_continuous(one)) count_constant(one, values);
    for (Machine& one : machines_)
      if (is_continuous(one)) count_machine(one, values);
    for (const Table& one : tables_)
      if (is_continuous(one)) count_table(one, values);
  }

  struct Crossings {
    const BlockType* type;
    const void* block;
    std::ptrdiff_t active;
    std::size_t owner;  ///< Index of the block.
    plan::Rate rate;
    bool is_located;
    std::size_t condition = 0;  ///< Index of its first condition, once counted.
    std::vector<double> numbers{};
    std::vector<std::int64_t> infinite{};  ///< Ticks at which a function has no bound.
    std::vector<SideOfZero> at_zero{};
    bool counted = false;  ///< The number of functions is known, from the first tick.
  };
  struct Guard {
    std::size_t place, condition;
  };
  struct Constant {
    std::size_t place, condition;
    std::ptrdiff_t active;
    plan::Rate rate;
    double first = nan;
  };
  struct Machine {
    std::size_t place, condition;  ///< Condition of its states; those of its transitions follow.
    std::ptrdiff_t active;
    plan::Rate rate;
    Chart chart;
    std::optional<std::size_t> state{};
  };
  struct Limit {
    std::size_t place, condition;
    std::ptrdiff_t active;
    plan::Rate rate;
    double limit;
  };
  struct Table {
    std::size_t condition;
    std::ptrdiff_t active;
    plan::Rate rate;
    TableRegions regions;
  };

  Branch& branch(std::size_t condition, std::size_t index) {
    return coverage_.conditions[condition].branches[index];
  }

  /// Counts an instant at which a block with these conditions is computed.
  void count_instant(std::size_t condition, std::size_t count = 1) {
    for (std::size_t k = 0; k < count; ++k) ++coverage_.conditions[condition + k].instants;
  }

  std::size_t add(std::size_t block, const std::string& what, const std::vector<std::string>& branches) {
    const diagram::DiagramBlock& of = plan_.diagram.blocks[block];
    Condition condition{of.name, of.type().name, what, {}};
    for (const std::string& name : branches) condition.branches.push_back({name, 0});
    coverage_.conditions.push_back(std::move(condition));
    return coverage_.conditions.size() - 1;
  }

  bool is_located(std::size_t block) const {
    return std::ranges::any_of(plan_.crossings,
                               [&](const plan::CrossingCall& call) { return call.block == block; });
  }

  void add_block(run::Executor& simulation, std::size_t block) {
    const plan::PlannedBlock& planned = plan_.blocks[block];
    const BlockType& type = plan_.diagram.blocks[block].type();
    if (planned.rate.kind == plan::Rate::Kind::constant) return;
    const std::ptrdiff_t active = plan::active_of(plan_, block);
    const bool guards = std::ranges::any_of(
        plan_.guards, [&](const plan::PlannedGuard& guard) { return guard.block == block; });
    if (guards) {
      guards_.push_back(
          {planned.outputs.front().offset, add(block, "the part or block", {"active", "inactive"})});
      return;
    }
    if (Chart chart = chart_of(plan_.diagram.blocks[block]); !chart.states.empty())
      return add_machine(block, active, std::move(chart));
    if (type.parameter("extrapolation")) add_table(simulation, block, active);
    if (type.steady) add_constants(block, active);
    const bool skips = planned.configuration && planned.configuration->skips_crossings;
    if (type.crossings.empty()) add_limits(simulation.diagram().blocks[block], block, active);
    if (type.run_crossings && !skips)
      crossings_.push_back({&type, address_of(simulation, block), active, block, planned.rate,
                            is_located(block), 0, std::vector<double>(room_for_crossings(planned, type))});
  }

  void add_machine(std::size_t block, std::ptrdiff_t active, Chart chart) {
    const auto output = static_cast<std::size_t>(plan_.diagram.blocks[block].type().output("state"));
    const std::size_t condition = add(block, "the state", chart.states);
    for (const ChartArrow& arrow : chart.arrows)
      add(block, fmt::format("the transition {} to {}", chart.states[arrow.from], chart.states[arrow.to]),
          {"taken"});
    machines_.push_back({plan_.blocks[block].outputs[output].offset, condition, active,
                         plan_.blocks[block].rate, std::move(chart)});
  }

  void add_table(run::Executor& simulation, std::size_t block, std::ptrdiff_t active) {
    const diagram::Diagram present = simulation.diagram();  // a sweep may change points
    auto regions = TableRegions::of(present.blocks[block], plan_.blocks[block]);
    if (!regions) return;
    const std::size_t condition = add(block, "the table", regions->names());
    tables_.push_back({condition, active, plan_.blocks[block].rate, std::move(*regions)});
  }

  void add_constants(std::size_t block, std::ptrdiff_t active) {
    const BlockType& type = plan_.diagram.blocks[block].type();
    for (std::size_t output = 0; output < type.outputs.size(); ++output) {
      const plan::SignalSlot& slot = plan_.blocks[block].outputs[output];
      for (std::size_t k = 0; k < static_cast<std::size_t>(slot.size); ++k)
        constants_.push_back(
            {slot.offset + k,
             add(block,
                 type.outputs[output].name + (slot.size > 1 ? fmt::format(" ({})", k + 1) : std::string()),
                 {"its first value", "another value"}),
             active, plan_.blocks[block].rate});
    }
  }

  /// Adds the limits of a block without crossing functions, as of a DiscretePID. A run may have values of its
  /// own for them.
  void add_limits(const diagram::DiagramBlock& present, std::size_t block, std::ptrdiff_t active) {
    const BlockType& type = present.type();
    for (const LimitNames& names : limit_names) {
      if (!type.parameter(names.lower) || !type.parameter(names.upper)) continue;
      const plan::SignalSlot* slot = slot_of(names.state, type, block);
      for (std::size_t k = 0; slot && k < static_cast<std::size_t>(slot->size); ++k)
        for (const bool is_upper : {false, true}) {
          const double limit = element_of(present, is_upper ? names.upper : names.lower, k);
          const std::string number = slot->size > 1 ? fmt::format(" ({})", k + 1) : std::string();
          if (!std::isfinite(limit)) continue;
          const std::string what =
              fmt::format("{}{} reaches the {} limit", names.what, number, is_upper ? "upper" : "lower");
          limits_.push_back({slot->offset + k, add(block, what, {"there", "within"}), active,
                             plan_.blocks[block].rate, limit});
        }
    }
  }

  /// Returns the place of a state, or of the first output; nullptr without one.
  const plan::SignalSlot* slot_of(const std::string& state, const BlockType& type, std::size_t block) const {
    const plan::PlannedBlock& planned = plan_.blocks[block];
    if (state.empty()) return planned.outputs.empty() ? nullptr : &planned.outputs.front();
    for (std::size_t i = 0; i < type.states.size(); ++i)
      if (type.states[i].name == state) return &planned.states[i];
    return nullptr;
  }

  static bool is_off(std::ptrdiff_t active, const double* values) {
    return active >= 0 && values[active] == 0.0;
  }

  /// Counts the functions that a block writes, and adds a condition for each.
  void count_functions(Crossings& one) {
    std::size_t count = one.numbers.size();
    while (count > 0 && std::bit_cast<std::uint64_t>(one.numbers[count - 1]) == unwritten) --count;
    one.numbers.resize(count);
    one.infinite.assign(count, 0);
    one.condition = coverage_.conditions.size();
    const diagram::DiagramBlock& block = plan_.diagram.blocks[one.owner];
    std::vector<std::string> docs = docs_of(plan_.blocks[one.owner], block.type());
    if (const auto formula = branches_of_formula(block); formula && formula->margins.size() < docs.size()) {
      const std::size_t points = formula->margins.size();
      one.infinite.resize(count / docs.size() * points);  // declaration by declaration, the first ones
      docs.resize(points);
    }
    one.at_zero = sides_of_zero(block, docs, one.infinite.size());
    for (const std::string& name : names_of(docs, one.infinite.size()))
      add(one.owner, name, {"above", "below"});
    one.counted = true;
  }

  void count_crossings(Crossings& one, const double* values) {
    if (!one.counted) std::ranges::fill(one.numbers, std::bit_cast<double>(unwritten));
    one.type->run_crossings(one.block, one.numbers.data());
    if (!one.counted) count_functions(one);
    if (is_off(one.active, values)) return;
    count_instant(one.condition, one.infinite.size());
    for (std::size_t k = 0; k < one.infinite.size(); ++k) {
      const double number = one.numbers[k];
      if (number == 0.0) ++coverage_.conditions[one.condition + k].zeros;
      if (std::isinf(number))
        ++one.infinite[k];
      else if (number == 0.0 && one.at_zero[k])
        ++branch(one.condition + k, *one.at_zero[k]).ticks;
      else if (number != 0.0 && !std::isnan(number))
        ++branch(one.condition + k, number > 0.0 ? above : below).ticks;
    }
  }

  void count_guard(const Guard& one, const double* values) {
    count_instant(one.condition);
    ++branch(one.condition, values[one.place] != 0.0 ? 0 : 1).ticks;
  }

  void count_constant(Constant& one, const double* values) {
    if (is_off(one.active, values)) return;
    count_instant(one.condition);
    const double value = values[one.place];
    if (std::isnan(one.first)) one.first = value;
    ++branch(one.condition, value == one.first ? 0 : 1).ticks;
  }

  void count_machine(Machine& one, const double* values) {
    if (is_off(one.active, values)) return;
    const auto state = static_cast<std::size_t>(values[one.place]);
    count_instant(one.condition, 1 + one.chart.arrows.size());
    if (state >= one.chart.states.size()) return;
    for (std::size_t s = 0; s < one.chart.states.size(); ++s)
      if (one.chart.is_within(state, s)) ++branch(one.condition, s).ticks;
    if (one.state && *one.state != state) count_arrows(one, *one.state, state);
    one.state = state;
  }

  void count_limit(const Limit& one, const double* values) {
    if (is_off(one.active, values)) return;
    count_instant(one.condition);
    ++branch(one.condition, values[one.place] == one.limit ? 0 : 1).ticks;
  }

  void count_table(const Table& one, const double* values) {
    if (is_off(one.active, values)) return;
    count_instant(one.condition);
    for (const std::size_t region : one.regions.at(values)) ++branch(one.condition, region).ticks;
  }

  /// Counts the transitions between two states. Those with the same ends are counted together.
  void count_arrows(const Machine& one, std::size_t from, std::size_t to) {
    for (std::size_t a = 0; a < one.chart.arrows.size(); ++a) {
      const ChartArrow& arrow = one.chart.arrows[a];
      if (one.chart.is_within(from, arrow.from) && one.chart.is_within(to, arrow.to))
        ++branch(one.condition + 1 + a, 0).ticks;
    }
  }

  const plan::Plan& plan_;
  Coverage coverage_;
  std::vector<Crossings> crossings_;
  std::vector<Guard> guards_;
  std::vector<Constant> constants_;
  std::vector<Machine> machines_;
  std::vector<Table> tables_;
  std::vector<Limit> limits_;
};

CoverageObserver::CoverageObserver() = default;
CoverageObserver::~CoverageObserver() = default;

void CoverageObserver::begin(const run::ObservedRun& run) {
  auto of_run = std::make_unique<OfRun>(run.simulation);
  const std::lock_guard lock(mutex_);
  runs_[run.index] = std::move(of_run);
}

void CoverageObserver::evaluated(const run::ObservedRun& run) {
  OfRun* of_run = nullptr;
  {
    const std::lock_guard lock(mutex_);
    of_run = runs_.at(run.index).get();
  }
  of_run->evaluate(run.simulation.values(), run.simulation.tick());
}

void CoverageObserver::end(const run::ObservedRun& run) {
  run.simulation.show_events(nullptr);
  const std::lock_guard lock(mutex_);
  all_.add(runs_.at(run.index)->finished());
  runs_.erase(run.index);
}

Coverage CoverageObserver::coverage() const {
  const std::lock_guard lock(mutex_);
  return all_;
}

std::size_t Condition::covered() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(branches, [](const Branch& branch) { return branch.ticks > 0; }));
}

std::size_t Coverage::branches() const {
  std::size_t count = 0;
  for (const Condition& condition : conditions) count += condition.branches.size();
  return count;
}

std::size_t Coverage::covered() const {
  std::size_t count = 0;
  for (const Condition& condition : conditions) count += condition.covered();
  return count;
}

void Coverage::add(const Coverage& other) {
  for (const Condition& one : other.conditions) {
    const auto known = std::ranges::find_if(conditions, [&](const Condition& condition) {
      return condition.block == one.block && condition.what == one.what &&
             std::ranges::equal(condition.branches, one.branches, {}, &Branch::name, &Branch::name);
    });
    if (known == conditions.end()) {
      conditions.push_back(one);
      continue;
    }
    known->instants += one.instants;
    known->zeros += one.zeros;
    for (std::size_t i = 0; i < one.branches.size(); ++i) known->branches[i].ticks += one.branches[i].ticks;
  }
}

/// Returns the lines of the branches of one condition that no run took.
static std::string missed_text(const Condition& condition) {
  const std::string begin = fmt::format("    {} ({}): {}: ", condition.block, condition.type, condition.what);
  if (condition.covered() == 0 && condition.zeros == condition.instants)
    return begin + "always exactly there, never above or below\n";
  std::string text;
  for (const Branch& branch : condition.branches)
    if (branch.ticks == 0) text += fmt::format("{}never {}\n", begin, branch.name);
  return text;
}

std::string coverage_text(const Coverage& coverage) {
  if (coverage.conditions.empty())
    return "  coverage: no block that changes during the run has a condition\n";
  std::string text = fmt::format("  coverage: {} of {} branches\n", coverage.covered(), coverage.branches());
  std::map<std::string, std::size_t> idle;  // branches of blocks that no run computes
  for (const Condition& condition : coverage.conditions)
    if (condition.instants == 0) idle[condition.block] += condition.branches.size();
  for (const Condition& condition : coverage.conditions) {
    if (condition.instants > 0) {
      text += missed_text(condition);
    } else if (const std::size_t count = std::exchange(idle[condition.block], 0)) {
      text += fmt::format("    {} ({}): never computed, so none of its {} branch{}\n", condition.block,
                          condition.type, count, count == 1 ? "" : "es");
    }
  }
  return text;
}

static void declare(result::Record<Branch>& is) {
  is.named("Branch", "Branch of a condition of a block.");
  is.field("name", &Branch::name, "name of the branch: above, below, active, a state");
  is.field("ticks", &Branch::ticks,
           "ticks and sides of located events at which the runs were there; 0 for one that none took");
}

static void declare(result::Record<Condition>& is) {
  is.named("Condition", "Condition of a block with its branches.");
  is.field("block", &Condition::block, "name of the block");
  is.field("type", &Condition::type, "type of the block");
  is.field("what", &Condition::what, "the condition");
  is.field("branches", &Condition::branches, "its branches");
}

void declare(result::Record<Coverage>& is) {
  is.named("Coverage", "Branches that the runs of a file took: run --coverage.");
  is.field("branches", &Coverage::branches, "number of branches");
  is.field("covered", &Coverage::covered, "number of those that a run took");
  is.field("conditions", &Coverage::conditions, "conditions of the blocks");
}

}  // namespace stepwire::coverage
