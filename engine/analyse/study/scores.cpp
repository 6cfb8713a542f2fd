#include "engine/analyse/study/scores.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "engine/analyse/statistics/descriptive.hpp"
#include "engine/analyse/statistics/repeated_measures.hpp"
#include "engine/analyse/statistics/statistics_error.hpp"
#include "engine/analyse/study/analysis.hpp"
#include "engine/analyse/study/comparison_tables.hpp"
#include "engine/base/csv/cell.hpp"
#include "engine/base/csv/decimal_survey.hpp"
#include "engine/base/csv/read_record.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/table/csv_cell.hpp"
#include "engine/base/table/csv_lines.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire::study {

using statistics::Factor;

using statistics::Observations;

using json::Json;

namespace {

template <class Item>
bool has(const std::vector<Item>& items, const Item& item) {
  return std::ranges::find(items, item) != items.end();
}

/// Reads the cells of a table. Throws TableError, also for a missing file.
auto read_texts(const std::string& path) try {
  return csv::read_texts(path);
} catch (const io::EnvironmentError& error) {
  throw table::TableError(error.what());
}

/// Reads the columns that a request names.
class ScoreReader {
 public:
  ScoreReader(const std::string& path, ScoresRequest& request)
      : path_(path), request_(request), table_(read_texts(path)) {
    for (const table::Column& column : table_.columns)
      if (!column.name.empty()) names_.push_back(column.name);
    complete();
  }

  Observations read() const {
    Observations result{request_.score, numbers(cells(request_.score)), {}};
    const std::string& unit = table_.columns[place(request_.score)].unit;
    if (!unit.empty()) result.response += fmt::format(" [{}]", unit);
    std::vector<std::string> all = request_.factors;
    if (!request_.subject.empty()) all.push_back(request_.subject);
    for (const std::string& name : all) result.factors.push_back(factor(name));
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw table::TableError(fmt::format("{}:1: {}", path_, message));
  }

  [[noreturn]] void fail_at(std::size_t row, const std::string& message) const {
    throw table::TableError(fmt::format("{}:{}: {} (column '{}')", path_, table_.lines[row], message,
                                        table::csv_shown(request_.score)));
  }

  std::size_t place(const std::string& name) const {
    return static_cast<std::size_t>(std::ranges::find(table_.columns, name, &table::Column::name) -
                                    table_.columns.begin());
  }
  const std::vector<std::string>& cells(const std::string& name) const { return table_.cells[place(name)]; }

  /// Returns the numbers of a column. The decimal mark is a point. It is a comma where the column proves
  /// that, by the rules of measured records.
  std::vector<double> numbers(const std::vector<std::string>& texts) const {
    const csv::Decimal decimal = decimal_of(texts);
    std::vector<double> numbers;
    for (std::size_t row = 0; row < texts.size(); ++row) {
      const std::string& text = texts[row];
      if (csv::is_missing(text)) fail_at(row, "the score is missing; leave the row out, or mend it");
      const auto value = number(text, decimal);
      if (!value) fail_at(row, fmt::format("'{}' {}", table::csv_shown(text), problem(text, decimal)));
      if (!std::isfinite(*value))
        fail_at(row, fmt::format("{} is no finite number; leave the row out, or mend it", *value));
      numbers.push_back(*value);
    }
    return numbers;
  }

  /// Returns the number of a cell; std::nullopt for a text, and for marks of thousands where points are
  /// decimal.
  static std::optional<double> number(const std::string& text, csv::Decimal decimal) {
    const auto cell = csv::cell_number(text, decimal);
    if (cell && (decimal == csv::Decimal::comma || !cell->grouped)) return table::csv_number(cell->text);
    return decimal == csv::Decimal::comma ? std::nullopt : table::csv_number(text);
  }

  static csv::Decimal decimal_of(const std::vector<std::string>& texts) {
    if (std::ranges::all_of(
            texts, [](const std::string& text) { return number(text, csv::Decimal::point).has_value(); }))
      return csv::Decimal::point;
    csv::DecimalSurvey survey(1);
    for (std::size_t row = 0; row < texts.size(); ++row) survey.add(0, texts[row], row);
    return survey.verdict(false).decimal;
  }

  static std::string problem(const std::string& word, csv::Decimal decimal) {
    const csv::Shape shape = csv::shape_of(word);
    const bool comma = decimal == csv::Decimal::comma;
    if (shape == csv::Shape::either_comma || shape == csv::Shape::grouped_point)
      return "may part thousands or be decimal; write scores with a decimal point and without marks of "
             "thousands";
    if (csv::cell_number(word, comma ? csv::Decimal::point : csv::Decimal::comma))
      return fmt::format(
          "has a decimal {}, but other scores a decimal {}; write one of them in the whole column",
          comma ? "point" : "comma", comma ? "comma" : "point");
    return table::csv_number_problem(word);
  }

  /// Sets the columns that the request leaves open, and checks those that it names.
  void complete() {
    if (names_.size() < 2) fail("scores need a column of numbers and one of a factor");
    if (request_.score.empty()) request_.score = names_.back();
    if (request_.factors.empty())
      for (const std::string& name : names_)
        if (name != request_.score && name != request_.subject) request_.factors.push_back(name);
    check(request_.score, "--score");
    if (!request_.subject.empty()) check(request_.subject, "--subject");
    for (const std::string& name : request_.factors) {
      check(name, "--factors");
      if (name == request_.score || name == request_.subject)
        fail(fmt::format("'{}' is a factor and also the score or the subject; take it out of --factors",
                         name));
    }
    if (request_.score == request_.subject) fail(fmt::format("'{}' is score and subject", request_.score));
    if (request_.factors.empty()) fail("there is no factor beside score and subject");
  }

  void check(const std::string& name, const char* option) const {
    if (!has(names_, name))
      fail((fmt::format("there is no column '{}' for {}", name, option) +
            yaml::nearest_or_all(name, names_, "there are"))
               .text());
  }

  /// Returns a factor, with its levels in the order of their appearance.
  Factor factor(const std::string& name) const {
    const std::vector<std::string>& texts = cells(name);
    Factor result{name, {}, {}, name == request_.subject};
    std::unordered_map<std::string, std::size_t> levels;
    std::map<double, std::string> spellings;
    const csv::Decimal decimal = decimal_of(texts);
    for (std::size_t row = 0; row < texts.size(); ++row) {
      if (texts[row].empty())
        throw table::TableError(fmt::format("{}:{}: '{}' is missing", path_, table_.lines[row], name));
      const auto [level, is_new] = levels.try_emplace(table::csv_word(texts[row]), result.levels.size());
      if (is_new) result.levels.push_back(level->first);
      if (is_new) refuse_other_spelling(name, row, number(texts[row], decimal), spellings);
      result.level.push_back(level->second);
    }
    return result;
  }

  /// Fails for a level that is the number of another one in other digits, as 1.0 beside 1.
  void refuse_other_spelling(const std::string& name, std::size_t row, const std::optional<double>& level,
                             std::map<double, std::string>& spellings) const {
    if (!level || std::isnan(*level)) return;
    const std::string& text = cells(name)[row];
    const auto [known, is_new] = spellings.try_emplace(*level, text);
    if (!is_new)
      throw table::TableError(fmt::format(
          "{}:{}: the level '{}' of '{}' is the number of the level '{}'; write one of them in all "
          "rows",
          path_, table_.lines[row], table::csv_shown(text), name, table::csv_shown(known->second)));
  }

  const std::string& path_;
  ScoresRequest& request_;
  csv::TextColumns table_;
  std::vector<std::string> names_;
};

/// True if each subject has one level of a factor only.
bool is_between(const Factor& factor, const Factor& subject) {
  std::vector<std::size_t> own(subject.levels.size(), factor.levels.size());
  for (std::size_t row = 0; row < factor.level.size(); ++row) {
    std::size_t& level = own[subject.level[row]];
    if (level != factor.levels.size() && level != factor.level[row]) return false;
    level = factor.level[row];
  }
  return true;
}

/// Removes some levels of a factor, and their rows.
Observations without(const Observations& all, const std::string& name,
                     const std::vector<std::size_t>& dropped) {
  Observations result{all.response, {}, all.factors};
  for (Factor& factor : result.factors) factor.level.clear();
  const auto gone = [&](std::size_t level) {
    return std::find(dropped.begin(), dropped.end(), level) != dropped.end();
  };
  for (std::size_t row = 0; row < all.values.size(); ++row) {
    if (gone(all.factor(name).level[row])) continue;
    result.values.push_back(all.values[row]);
    for (std::size_t k = 0; k < all.factors.size(); ++k)
      result.factors[k].level.push_back(all.factors[k].level[row]);
  }
  for (Factor& factor : result.factors) {
    std::vector<std::string> words;
    for (const std::size_t level : factor.level) words.push_back(factor.levels[level]);
    factor = statistics::make_factor(factor.name, words, factor.subject);
  }
  return result;
}

/// Returns the factors within subjects of which most subjects have one level: "'g' counts as within subjects,
/// since s 3 has several levels of it".
std::string doubtful_within(const ScoresAnalysis& analysis) {
  const Observations& all = analysis.observations;
  const Factor& subject = all.factor(analysis.request.subject);
  std::string text;
  for (const std::string& name : analysis.within) {
    const Factor& factor = all.factor(name);
    std::vector<std::set<std::size_t>> own(subject.levels.size());
    for (std::size_t row = 0; row < factor.level.size(); ++row)
      own[subject.level[row]].insert(factor.level[row]);
    const auto several = std::ranges::find_if(own, [](const auto& levels) { return levels.size() > 1; });
    if (2 * std::ranges::count_if(own, [](const auto& levels) { return levels.size() > 1; }) >
        std::ssize(own))
      continue;
    text += fmt::format("; '{}' counts as within subjects, since {} {} has several levels of it", name,
                        subject.name, subject.levels[static_cast<std::size_t>(several - own.begin())]);
  }
  return text;
}

/// Returns the first few of some texts, and the number of the others.
std::string first_of(const std::vector<std::string>& texts) {
  constexpr std::size_t most = 6;
  const std::size_t count = std::min(most, texts.size());
  return fmt::format("{}{}",
                     fmt::join(texts.begin(), texts.begin() + static_cast<std::ptrdiff_t>(count), "; "),
                     count < texts.size() ? fmt::format("; and {} more", texts.size() - count) : "");
}

/// Removes subjects without a score in one of the cells within subjects. Throws StatisticsError where fewer
/// than two are left.
void leave_out(ScoresAnalysis& analysis) {
  std::vector<std::string> by{analysis.request.subject};
  by.insert(by.end(), analysis.within.begin(), analysis.within.end());
  std::vector<std::size_t> dropped;
  for (const statistics::Cell& cell : cells(analysis.observations, by)) {
    if (!cell.values.empty()) continue;
    if (!has(dropped, cell.levels[0])) dropped.push_back(cell.levels[0]);
    analysis.left_out.push_back("no score for " + cell_name(analysis.observations, by, cell));
  }
  if (dropped.empty()) return;
  const std::size_t left = analysis.observations.factor(by.front()).levels.size() - dropped.size();
  if (left < 2)
    throw statistics::StatisticsError(fmt::format(
        "repeated measures need two subjects with a score in each cell, and there {}: {}{}",
        left == 0 ? "is none" : "is one", first_of(analysis.left_out), doubtful_within(analysis)));
  analysis.observations = without(analysis.observations, analysis.request.subject, dropped);
}

/// True where each level of a factor has the rows of one level of another one.
bool are_alike(const Factor& one, const Factor& other) {
  if (one.levels.size() != other.levels.size() || one.levels.size() < 2) return false;
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t row = 0; row < one.level.size(); ++row) pairs.emplace(one.level[row], other.level[row]);
  return pairs.size() == one.levels.size();
}

/// Throws StatisticsError for two factors that are one under two names.
void refuse_alike(const ScoresAnalysis& analysis) {
  const std::vector<std::string>& names = analysis.request.factors;
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t k = i + 1; k < names.size(); ++k)
      if (are_alike(analysis.observations.factor(names[i]), analysis.observations.factor(names[k])))
        throw statistics::StatisticsError(
            fmt::format("the factors '{}' and '{}' have the same rows at each level, so that their effects "
                        "cannot be told apart; name one of them in --factors",
                        names[i], names[k]));
}

/// Returns the factor whose levels are the cells within subjects; adds it if there are several factors.
std::string add_condition(Observations& observations, const std::vector<std::string>& within) {
  if (within.size() == 1) return within.front();
  std::vector<std::string> words(observations.values.size());
  for (const std::string& name : within)
    for (std::size_t row = 0; row < words.size(); ++row) {
      const Factor& factor = observations.factor(name);
      words[row] += (words[row].empty() ? "" : " ") + factor.levels[factor.level[row]];
    }
  std::string name = "condition";
  const auto taken = [&] {
    return std::ranges::any_of(observations.factors, [&](const Factor& one) { return one.name == name; });
  };
  while (taken()) name += "'";
  observations.factors.push_back(statistics::make_factor(name, words));
  return name;
}

constexpr std::size_t most_conditions = 20;  // limit of conditions, for readable tables of pairs

void analyse_subjects(ScoresAnalysis& analysis) {
  const std::string& subject = analysis.request.subject;
  const Factor who = analysis.observations.factor(subject);
  for (const std::string& name : analysis.request.factors)
    (is_between(analysis.observations.factor(name), who) ? analysis.between : analysis.within)
        .push_back(name);
  leave_out(analysis);
  const Observations& scores = analysis.observations;
  analysis.anova = statistics::repeated_measures(scores, analysis.within, subject, analysis.between);
  if (!analysis.between.empty()) return;
  Observations all = scores;
  const std::string condition = add_condition(all, analysis.within);
  const std::vector<std::string> order = all.factor(condition).levels;
  if (order.size() <= most_conditions)
    analysis.pairs = statistics::within_subjects(all, analysis.within, order, condition, subject);
}

void analyse_independent(ScoresAnalysis& analysis) {
  const ScoresRequest& request = analysis.request;
  analysis.between = request.factors;
  analysis.anova = statistics::anova(analysis.observations,
                                     request.additive ? statistics::additive_terms(request.factors)
                                                      : statistics::crossed_terms(request.factors),
                                     request.sums);
  if (cells(analysis.observations, request.factors).size() <= most_conditions)
    analysis.groups = statistics::independent_pairs(analysis.observations, request.factors);
}

double mean_of(const statistics::Cell& cell) {
  return statistics::moments_of(cell.values).mean;
}

/// Returns the standard deviation of the sample; nan for a single value.
double deviation_of(const statistics::Cell& cell) {
  return std::sqrt(statistics::moments_of(cell.values).squares /
                   (static_cast<double>(cell.values.size()) - 1.0));
}

std::string shown_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "–";
}

text::TextTable cell_table(const ScoresAnalysis& analysis) {
  text::TextTable table{"Cells of " + analysis.observations.response, analysis.request.factors, {}, {}};
  table.columns.insert(table.columns.end(), {"scores", "mean", "standard deviation"});
  for (const statistics::Cell& cell : cells(analysis.observations, analysis.request.factors)) {
    std::vector<std::string> row;
    for (std::size_t k = 0; k < cell.levels.size(); ++k)
      row.push_back(analysis.observations.factor(analysis.request.factors[k]).levels[cell.levels[k]]);
    row.push_back(std::to_string(cell.values.size()));
    row.push_back(cell.values.empty() ? "–" : shown_number(mean_of(cell)));
    row.push_back(cell.values.size() < 2 ? "–" : shown_number(deviation_of(cell)));
    table.rows.push_back(std::move(row));
  }
  for (const std::string& one : analysis.left_out) table.notes.push_back("Left out: " + one + ".");
  return table;
}

text::TextTable groups_table(const ScoresAnalysis& analysis) {
  text::TextTable table{
      "Comparisons of groups",
      {"pair", "mean difference", "from", "to", "t", "degrees of freedom", "P", "P (Holm)"},
      {},
      {fmt::format("First minus second. Independent scores: t test of Welch, whose variances may "
                   "differ; from, to: at 95 % confidence, uncorrected. P (Holm): corrected for {} "
                   "comparison{}.",
                   analysis.groups.size(), analysis.groups.size() == 1 ? "" : "s")}};
  for (const statistics::IndependentPair& pair : analysis.groups)
    table.rows.push_back({pair.first + " - " + pair.second, shown_number(pair.difference),
                          shown_number(pair.interval.low), shown_number(pair.interval.high),
                          shown_number(pair.t), shown_number(pair.freedom), printed_probability(pair.p),
                          printed_probability(pair.holm)});
  return table;
}

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json groups_json(const ScoresAnalysis& analysis) {
  if (analysis.groups.empty()) return {};
  Json list = Json::list();
  for (const statistics::IndependentPair& pair : analysis.groups)
    list.push(Json::object()
                  .set("first", pair.first)
                  .set("second", pair.second)
                  .set("difference", pair.difference)
                  .set("low", number_or_null(pair.interval.low))
                  .set("high", number_or_null(pair.interval.high))
                  .set("t", number_or_null(pair.t))
                  .set("degrees_of_freedom", number_or_null(pair.freedom))
                  .set("P", number_or_null(pair.p))
                  .set("P_holm", number_or_null(pair.holm)));
  return list;
}

std::string listed_names(const std::vector<std::string>& names) {
  return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

Json cells_json(const ScoresAnalysis& analysis) {
  Json list = Json::list();
  for (const statistics::Cell& cell : cells(analysis.observations, analysis.request.factors)) {
    Json levels = Json::object();
    for (std::size_t k = 0; k < cell.levels.size(); ++k)
      levels.set(analysis.request.factors[k],
                 analysis.observations.factor(analysis.request.factors[k]).levels[cell.levels[k]]);
    list.push(Json::object()
                  .set("levels", std::move(levels))
                  .set("scores", cell.values.size())
                  .set("mean", cell.values.empty() ? Json() : Json(mean_of(cell)))
                  .set("standard_deviation", cell.values.size() < 2 ? Json() : Json(deviation_of(cell))));
  }
  return list;
}

}  // namespace

ScoresAnalysis analyse_scores(const std::string& path, ScoresRequest request) {
  ScoresAnalysis analysis;
  analysis.observations = ScoreReader(path, request).read();
  analysis.request = std::move(request);
  try {
    analysis.observations.check();
    refuse_alike(analysis);
    analysis.request.subject.empty() ? analyse_independent(analysis) : analyse_subjects(analysis);
  } catch (const statistics::StatisticsError& error) {
    throw table::TableError(fmt::format("{}: {}", path, error.what()));
  }
  return analysis;
}

std::vector<text::TextTable> score_tables(const ScoresAnalysis& analysis) {
  const bool subjects = !analysis.request.subject.empty();
  std::vector<text::TextTable> tables{cell_table(analysis)};
  tables.push_back(anova_table(analysis.anova, subjects ? "Repeated measures" : "Analysis of variance"));
  if (subjects)
    tables.back().notes.push_back(fmt::format("Within subjects: {}. Between subjects: {}.",
                                              listed_names(analysis.within), listed_names(analysis.between)));
  if (!analysis.groups.empty()) tables.push_back(groups_table(analysis));
  if (!analysis.pairs) return tables;
  for (const std::string& name : comparison_table_names())
    if (name != "power" || analysis.request.power_seed)
      tables.push_back(comparison_table(name, *analysis.pairs, "", analysis.request.power_seed.value_or(1)));
  return tables;
}

Json scores_json(const std::string& path, const ScoresAnalysis& analysis) {
  const statistics::Anova& anova = analysis.anova;
  const bool subjects = !analysis.request.subject.empty();
  return Json::object()
      .set("file", path)
      .set("score", analysis.request.score)
      .set("subject", subjects ? Json(analysis.request.subject) : Json())
      .set("within", Json::list_of(analysis.within))
      .set("between", Json::list_of(analysis.between))
      .set("left_out", Json::list_of(analysis.left_out))
      .set("cells", cells_json(analysis))
      .set(subjects ? "repeated_measures" : "anova", anova_json(anova))
      .set("r_squared",
           subjects ? Json() : Json(1.0 - anova.residual.sum_of_squares / anova.total.sum_of_squares))
      .set("residual_deviation", subjects ? Json() : Json(std::sqrt(anova.residual.mean_square)))
      .set("groups", groups_json(analysis))
      .set("within_subjects",
           analysis.pairs ? comparisons_json(*analysis.pairs, analysis.request.power_seed) : Json());
}

}  // namespace stepwire::study
