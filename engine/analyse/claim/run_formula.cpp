// Reads run formulas. Each call of a reduction in the text is replaced by a name of the same length, so that
// the columns of faults remain valid.
#include "engine/analyse/claim/run_formula.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "engine/analyse/claim/reduced_value.hpp"
#include "engine/analyse/query/names_reading.hpp"
#include "engine/analyse/query/number.hpp"

namespace stepwire::claim {
namespace {

using RunValues = std::vector<std::optional<double>>;

/// Returns the value of a parameter in a run, from the run's first row: it is the same in all rows.
double parameter_of(const std::string& name, std::span<const record::Recording> recordings, std::size_t run) {
  const record::Recording& first = recordings.front();
  const table::Column* column = first.table.find(name);
  if (!column || run >= first.starts.size() || first.starts[run] >= column->values.size())
    return query::nothing;
  return column->values[first.starts[run]];
}

/// Returns the arguments of the formula for one run; std::nullopt if a reduction selects no row of it.
std::optional<std::vector<double>> numbers_of(const RunFormula& formula,
                                              const std::vector<RunValues>& reduced,
                                              std::span<const record::Recording> recordings,
                                              std::size_t run) {
  std::vector<double> numbers;
  for (const std::string& name : formula.formula->columns) {
    const auto found = std::ranges::find(formula.names, name);
    if (found == formula.names.end()) {
      numbers.push_back(parameter_of(name, recordings, run));
      continue;
    }
    const std::optional<double>& value =
        reduced[static_cast<std::size_t>(found - formula.names.begin())][run];
    if (!value) return std::nullopt;
    numbers.push_back(*value);
  }
  return numbers;
}

/// Range of characters in the text.
struct Piece {
  std::size_t begin = 0, end = 0;
};

/// Call of a reduction in the text.
struct Call {
  Reduction reduction{};
  Piece whole{};
  std::vector<Piece> arguments{};
};

/// Calls visit(i) for the characters of a piece outside of brackets and quotes.
template <class Visit>
void for_each_outer(const std::string& text, const Piece& piece, Visit visit) {
  int depth = 0;
  char quote = 0;
  for (std::size_t i = piece.begin; i < piece.end; ++i) {
    const char c = text[i];
    if (quote || c == '"' || c == '\'') {
      quote = quote == 0 ? c : (c == quote ? char{0} : quote);
      continue;
    }
    if (c == ')' || c == ']') --depth;
    if (depth == 0) visit(i);
    if (c == '(' || c == '[') ++depth;
  }
}

/// Returns the position of the bracket that closes the one at `open`; npos if it is not closed.
std::size_t closing(const std::string& text, std::size_t open) {
  std::size_t found = std::string::npos;
  for_each_outer(text, {open, text.size()}, [&](std::size_t i) {
    if (text[i] == ')' && found == std::string::npos) found = i;
  });
  return found;
}

std::vector<Piece> arguments_in(const std::string& text, Piece inside) {
  std::vector<Piece> all;
  std::size_t begin = inside.begin;
  for_each_outer(text, inside, [&](std::size_t i) {
    if (text[i] != ',') return;
    all.push_back({begin, i});
    begin = i + 1;
  });
  all.push_back({begin, inside.end});
  return all;
}

std::size_t arguments_of(Reduction reduction) {
  const bool two = reduction == Reduction::at || reduction == Reduction::quantile ||
                   reduction == Reduction::rising || reduction == Reduction::fit;
  return two ? 2 : 1;
}

/// Parses the call of a reduction that begins at `begin`; std::nullopt if there is none. `max` and `min` with
/// several arguments are ordinary functions.
std::optional<Call> call_at(const std::string& text, std::size_t begin) {
  if (begin > 0 && (query::is_word(text[begin - 1]) || text[begin - 1] == '.' || text[begin - 1] == '$'))
    return std::nullopt;
  const std::string name = query::name_at(text, begin);
  const auto& all = reduction_names();
  const auto found = std::ranges::find(all, name);
  const std::size_t open = text.find_first_not_of(' ', begin + name.size());
  if (name.empty() || found == all.end() || open == std::string::npos || text[open] != '(')
    return std::nullopt;
  const std::size_t end = closing(text, open);
  if (end == std::string::npos) return std::nullopt;
  if (is_of_runs(static_cast<Reduction>(found - all.begin()))) return std::nullopt;
  Call call{
      static_cast<Reduction>(found - all.begin()), {begin, end + 1}, arguments_in(text, {open + 1, end})};
  const bool extreme = call.reduction == Reduction::max || call.reduction == Reduction::min;
  if (extreme && call.arguments.size() > 1) return std::nullopt;
  return call;
}

std::vector<Call> calls_in(const std::string& text) {
  std::vector<Call> calls;
  for (std::size_t i = 0; i < text.size();) {
    if (auto call = call_at(text, i)) {
      i = call->whole.end;
      calls.push_back(std::move(*call));
    } else {
      ++i;
    }
  }
  return calls;
}

/// Reads one run formula: first the reductions that it calls, with their arguments and conditions, then the
/// text in which names replace these calls.
class RunFormulaReader {
 public:
  RunFormulaReader(const yaml::Node& node, const query::NamesReading& read) : node_(node), read_(read) {}

  std::optional<RunFormula> read() {
    if (!node_.is_scalar() || node_.text.empty()) return refused("is an expression of reductions: rms(x)");
    const std::size_t before = read_.faults.size();
    formula_.text = node_.text;
    std::string text = node_.text;
    for (const Call& call : calls_in(node_.text)) {
      formula_.reductions.push_back(reduction(call));
      formula_.names.push_back(name_of(call, formula_.names.size()));
      text.replace(call.whole.begin, call.whole.end - call.whole.begin, formula_.names.back());
    }
    refuse_rows(text);
    if (read_.faults.size() != before) return std::nullopt;
    query::SymbolTable names = outer_names();
    for (std::size_t i = 0; i < formula_.names.size(); ++i) {
      names.columns.push_back({formula_.names[i], reduced_dimension(formula_.reductions[i]), {}});
      names.columns.back().is_ratio = is_ratio(formula_.reductions[i]);
    }
    auto formula = query::read_formula(node_, text, 0, names, read_.subject, read_.faults);
    if (!formula) return std::nullopt;
    formula_.formula = std::move(*formula);
    if (formula_.reductions.empty() && formula_.formula->columns.empty())
      return refused(fmt::format("'{}' has no number of a run, such as rms(x)", node_.text));
    return std::move(formula_);
  }

 private:
  std::nullopt_t refused(const std::string& message) {
    read_.fault(node_.mark, message);
    return std::nullopt;
  }

  /// Returns a name as long as the call; no name of a diagram has this form.
  static std::string name_of(const Call& call, std::size_t number) {
    std::string name = fmt::format("_{}", number);
    name.resize(std::max(name.size(), call.whole.end - call.whole.begin), '_');
    return name;
  }

  yaml::Node node_of(Piece piece) const {
    const std::string& text = node_.text;
    while (piece.begin < piece.end && text[piece.begin] == ' ') ++piece.begin;
    while (piece.end > piece.begin && text[piece.end - 1] == ' ') --piece.end;
    yaml::Node part = node_;
    part.mark = query::place_in(node_, piece.begin, read_.names).mark;
    part.text = text.substr(piece.begin, piece.end - piece.begin);
    part.quoted = false;
    return part;
  }

  Claim reduction(const Call& call) {
    Claim one;
    one.reduction = call.reduction;
    one.each_run = true;
    one.place = query::place_in(node_, call.whole.begin, read_.names);
    const std::string& name = reduction_names()[static_cast<std::size_t>(call.reduction)];
    if (call.arguments.size() != arguments_of(call.reduction)) {
      read_.fault(one.place.mark, fmt::format("'{}' takes {}, not {}", name,
                                              arguments_of(call.reduction) == 1 ? "one expression" : "two",
                                              call.arguments.size()));
      return one;
    }
    std::vector<Piece> arguments = call.arguments;
    read_where(arguments.back(), one);
    for (std::size_t i = 0; i < arguments.size(); ++i) read_argument(i, node_of(arguments[i]), one);
    read_recording(one);
    return one;
  }

  /// Reads the condition after "where" and cuts it from the argument.
  void read_where(Piece& argument, Claim& one) {
    const std::string word = " where ";
    std::size_t at = std::string::npos;
    for_each_outer(node_.text, argument, [&](std::size_t i) {
      if (node_.text.compare(i, word.size(), word) == 0) at = i;
    });
    if (at == std::string::npos) return;
    const yaml::Node where = node_of({at + word.size(), argument.end});
    argument.end = at;
    one.where = query::read_formula(where, read_.names, read_.subject, read_.faults);
  }

  void read_argument(std::size_t i, const yaml::Node& node, Claim& one) {
    const bool is_number = i == 1 && (one.reduction == Reduction::at || one.reduction == Reduction::quantile);
    if (is_number) return read_number(node, one);
    if (auto value = query::read_formula(node, read_.names, read_.subject, read_.faults))
      one.values.push_back(std::move(*value));
  }

  void read_number(const yaml::Node& node, Claim& one) {
    const auto number = query::read_number(node, read_.names, read_.subject, read_.faults);
    if (!number) return;
    const bool is_time = one.reduction == Reduction::at;
    query::check_dimension(*number,
                           {is_time ? unit::parse_unit("s")->dimension : unit::Dimension{}, !is_time},
                           is_time ? "a time" : "a share", node, read_.names, read_.subject, read_.faults);
    if (!is_time && !(number->value >= 0.0 && number->value <= 1.0))
      read_.fault(node.mark, fmt::format("the share {} is not within 0 and 1", node.text));
    (is_time ? one.time : one.share) = number->value;
  }

  void read_recording(Claim& one) {
    std::vector<const query::Formula*> all;
    for (const query::Formula& value : one.values) all.push_back(&value);
    if (one.where) all.push_back(&*one.where);
    one.recording = query::common_recording(all, read_.names, node_, read_.subject, read_.faults);
  }

  /// Adds a fault for a name outside of a reduction that is not a single number per run.
  void refuse_rows(const std::string& text) {
    std::vector<std::string> used;
    try {
      used = expression::Expression(text).variables();
    } catch (const expression::ExpressionError&) {
      return;  // the reader of the formula reports it with its place
    }
    const query::SymbolTable outer = outer_names();
    const auto is_parameter = [&](const std::string& name) {
      return std::ranges::find(outer.parameters, name, &query::KnownParameter::name) !=
                 outer.parameters.end() ||
             std::ranges::find(outer.drawn, name, &query::NamedFormula::name) != outer.drawn.end();
    };
    for (const std::string& name : used)
      if (std::ranges::find(formula_.names, name) == formula_.names.end() && !outer.find(name) &&
          !is_parameter(name))
        read_.fault(query::place_in(node_, text.find(name), read_.names).mark,
                    query::unknown_column(name, outer));
  }

  /// Returns the names with one number per run: swept and tuned parameters, and all constants.
  query::SymbolTable outer_names() const {
    query::SymbolTable names;
    names.file = read_.names.file;
    names.parameters = read_.names.parameters;
    names.drawn = read_.names.drawn;
    names.unknown = "is no number of a run; reduce what is recorded, as in rms(x) or settling_time(x)";
    for (const query::RecordedName& column : read_.names.columns)
      if (!column.recording && column.name != "time") names.columns.push_back(column);
    return names;
  }

  const yaml::Node& node_;
  const query::NamesReading& read_;
  RunFormula formula_;
};

}  // namespace

std::vector<std::string> RunFormula::columns() const {
  std::vector<std::string> all = formula->columns;
  for (const Claim& one : reductions) {
    for (const query::Formula& value : one.values)
      all.insert(all.end(), value.columns.begin(), value.columns.end());
    if (one.where) all.insert(all.end(), one.where->columns.begin(), one.where->columns.end());
  }
  return all;
}

RunValues values_of(const RunFormula& formula, std::span<const record::Recording> recordings) {
  std::vector<RunValues> reduced;
  std::size_t runs = recordings.empty() ? 0 : recordings.front().starts.size();
  for (const Claim& one : formula.reductions) {
    reduced.push_back(values_of_runs(one, recordings));
    runs = std::min(runs, reduced.back().size());
  }
  RunValues values(runs);
  for (std::size_t run = 0; run < runs; ++run)
    if (const auto numbers = numbers_of(formula, reduced, recordings, run))
      values[run] = formula.formula->expression(*numbers);
  return values;
}

bool has_reduction(const std::string& text) {
  return !calls_in(text).empty();
}

std::optional<RunFormula> read_run_formula(const yaml::Node& node, const query::NamesReading& read) {
  return RunFormulaReader(node, read).read();
}

}  // namespace stepwire::claim
