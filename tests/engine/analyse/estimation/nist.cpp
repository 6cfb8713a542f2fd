#include "tests/engine/analyse/estimation/nist.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

namespace stepwire {

namespace {

const std::string exponentials = "b1*exp(-b2*x) + b3*exp(-b4*x) + b5*exp(-b6*x)";
const std::string peaks = "b1*exp(-b2*x) + b3*exp(-(x-b4)^2/b5^2) + b6*exp(-(x-b7)^2/b8^2)";
const std::string decay = "exp(-b1*x)/(b2+b3*x)";
const std::string cubics = "(b1+b2*x+b3*x^2+b4*x^3)/(1+b5*x+b6*x^2+b7*x^3)";
const std::string growth = "b1*(1-exp(-b2*x))";

/// The models of the sets; that of Nelson describes the logarithm of y.
const std::map<std::string, std::string> models{
    {"Bennett5", "b1*(b2+x)^(-1/b3)"},
    {"BoxBOD", growth},
    {"Chwirut1", decay},
    {"Chwirut2", decay},
    {"DanWood", "b1*x^b2"},
    {"ENSO",
     "b1 + b2*cos(2*pi*x/12) + b3*sin(2*pi*x/12) + b5*cos(2*pi*x/b4) + b6*sin(2*pi*x/b4)"
     " + b8*cos(2*pi*x/b7) + b9*sin(2*pi*x/b7)"},
    {"Eckerle4", "(b1/b2)*exp(-0.5*((x-b3)/b2)^2)"},
    {"Gauss1", peaks},
    {"Gauss2", peaks},
    {"Gauss3", peaks},
    {"Hahn1", cubics},
    {"Kirby2", "(b1+b2*x+b3*x^2)/(1+b4*x+b5*x^2)"},
    {"Lanczos1", exponentials},
    {"Lanczos2", exponentials},
    {"Lanczos3", exponentials},
    {"MGH09", "b1*(x^2+x*b2)/(x^2+x*b3+b4)"},
    {"MGH10", "b1*exp(b2/(x+b3))"},
    {"MGH17", "b1 + b2*exp(-x*b4) + b3*exp(-x*b5)"},
    {"Misra1a", growth},
    {"Misra1b", "b1*(1-(1+b2*x/2)^(-2))"},
    {"Misra1c", "b1*(1-(1+2*b2*x)^(-0.5))"},
    {"Misra1d", "b1*b2*x/(1+b2*x)"},
    {"Nelson", "b1 - b2*x*exp(-b3*x2)"},
    {"Rat42", "b1/(1+exp(b2-b3*x))"},
    {"Rat43", "b1/((1+exp(b2-b3*x))^(1/b4))"},
    {"Roszman1", "b1 - b2*x - atan(b3/(x-b4))/pi"},
    {"Thurber", cubics}};

const std::map<std::string, std::string> small_texts{
    {"BoxBOD", R"(b1 = 1 100 2.1380940889E+02 1.2354515176E+01
b2 = 1 0.75 5.4723748542E-01 1.0455993237E-01
Residual Sum of Squares: 1.1680088766E+03
Data: y x
109 1
149 2
149 3
191 5
213 7
224 10
)"},
    {"DanWood", R"(b1 = 1 0.7 7.6886226176E-01 1.8281973860E-02
b2 = 5 4 3.8604055871E+00 5.1726610913E-02
Residual Sum of Squares: 4.3173084083E-03
Data: y x
2.138 1.309
3.421 1.471
3.597 1.49
4.34 1.565
4.882 1.611
5.66 1.68
)"},
    {"Rat42", R"(b1 = 100 75 7.2462237576E+01 1.7340283401E+00
b2 = 1 2.5 2.6180768402E+00 8.8295217536E-02
b3 = 0.1 0.07 6.7359200066E-02 3.4465663377E-03
Residual Sum of Squares: 8.0565229338E+00
Data: y x
8.93 9
10.8 14
18.59 21
22.33 28
39.35 42
56.11 57
61.73 63
64.62 70
67.08 79
)"},
    {"MGH09", R"(b1 = 25 0.25 1.9280693458E-01 1.1435312227E-02
b2 = 39 0.39 1.9128232873E-01 1.9633220911E-01
b3 = 41.5 0.415 1.2305650693E-01 8.0842031232E-02
b4 = 39 0.39 1.3606233068E-01 9.0025542308E-02
Residual Sum of Squares: 3.0750560385E-04
Data: y x
0.1957 4
0.1947 2
0.1735 1
0.16 0.5
0.0844 0.25
0.0627 0.167
0.0456 0.125
0.0342 0.1
0.0323 0.0833
0.0235 0.0714
0.0246 0.0625
)"},
    {"MGH10", R"(b1 = 2 0.02 5.6096364710E-03 1.5687892471E-04
b2 = 400000 4000 6.1813463463E+03 2.3309021107E+01
b3 = 25000 250 3.4522363462E+02 7.8486103508E-01
Residual Sum of Squares: 8.7945855171E+01
Data: y x
34780 50
28610 55
23650 60
19630 65
16370 70
13720 75
11540 80
9744 85
8261 90
7030 95
6005 100
5147 105
4427 110
3820 115
3307 120
2872 125
)"},
    {"Misra1a", R"(b1 = 500 250 2.3894212918E+02 2.7070075241E+00
b2 = 0.0001 0.0005 5.5015643181E-04 7.2668688436E-06
Residual Sum of Squares: 1.2455138894E-01
Data: y x
10.07 77.6
14.73 114.9
17.94 141.1
23.93 190.8
29.61 239.9
35.18 289
40.02 332.8
44.82 378.4
50.76 434.8
55.05 477.3
61.01 536.8
66.4 593.1
75.47 689.1
81.78 760
)"}};

std::vector<double> numbers_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<double> numbers;
  for (double one = 0.0; stream >> one;) numbers.push_back(one);
  return numbers;
}

void add_row(const std::vector<double>& row, NistSet& set) {
  if (row.size() < 2) return;
  set.y.push_back(set.name == "Nelson" ? std::log(row[0]) : row[0]);
  set.x.resize(row.size() - 1);
  for (std::size_t k = 1; k < row.size(); ++k) set.x[k - 1].push_back(row[k]);
}

/// "b1 = start start value error".
void add_parameter(const std::vector<double>& row, NistSet& set) {
  set.starts[0].push_back(row.at(0));
  set.starts[1].push_back(row.at(1));
  set.certified.push_back(row.at(2));
  set.errors.push_back(row.at(3));
}

/// The model over the elements of an Expression: the predictors, then the parameters.
std::string over_elements(std::string text, const NistSet& set) {
  text = std::regex_replace(text, std::regex("\\bx\\b"), "u1");
  text = std::regex_replace(text, std::regex("\\bx2\\b"), "u2");
  for (std::size_t k = set.certified.size(); k-- > 0;)
    text = std::regex_replace(text, std::regex(fmt::format("\\bb{}\\b", k + 1)),
                              fmt::format("u{}", k + 1 + set.x.size()));
  return text;
}

std::string table_block(const std::string& name, const std::vector<double>& values) {
  std::vector<std::size_t> rows(values.size());
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k] = k;
  return fmt::format("  {}: {{block: LookupTable, u: t, points: [{}], values: [{}]}}\n", name,
                     fmt::join(rows, ", "), fmt::join(values, ", "));
}

}  // namespace

NistSet nist_set(const std::string& name, const std::string& text) {
  NistSet set;
  set.name = name;
  std::istringstream lines(text);
  bool data = false;
  for (std::string line; std::getline(lines, line);) {
    std::smatch found;
    if (data)
      add_row(numbers_of(line), set);
    else if (std::regex_match(line, found, std::regex("\\s*b\\d+\\s*=(.*)")))
      add_parameter(numbers_of(found[1]), set);
    else if (std::regex_search(line, found, std::regex("Residual Sum of Squares:(.*)")))
      set.squares = numbers_of(found[1]).at(0);
    else
      data = std::regex_search(line, std::regex("^Data:\\s+y"));
  }
  return set;
}

std::vector<NistSet> small_nist_sets() {
  std::vector<NistSet> sets;
  for (const auto& [name, text] : small_texts) sets.push_back(nist_set(name, text));
  return sets;
}

std::vector<NistSet> all_nist_sets() {
  const char* folder = std::getenv("STEPWIRE_DATA");
  std::vector<NistSet> sets;
  if (!folder) return sets;
  for (const auto& [name, model] : models) {
    std::ifstream file(fmt::format("{}/nist_strd/{}.dat", folder, name));
    if (!file) return {};
    std::stringstream text;
    text << file.rdbuf();
    sets.push_back(nist_set(name, text.str()));
  }
  return sets;
}

std::string nist_diagram(const NistSet& set, std::size_t start, const std::string& more) {
  std::string parameters, sought, sources, tables;
  for (std::size_t k = 0; k < set.x.size(); ++k) {
    tables += table_block(fmt::format("x{}", k + 1), set.x[k]);
    sources += fmt::format("{}x{}", k == 0 ? "" : ", ", k + 1);
  }
  for (std::size_t k = 0; k < set.certified.size(); ++k) {
    parameters += fmt::format("  b{}: {{value: {}, doc: of the model}}\n", k + 1, set.starts[start][k]);
    sought += fmt::format("{}b{}: {{start: {}}}", k == 0 ? "" : ", ", k + 1, set.starts[start][k]);
    sources += fmt::format(", $b{}", k + 1);
  }
  return fmt::format(
      "step: 1 s\nstop: {} s\nparameters:\n{}blocks:\n  t: {{block: Ramp, slope: 1}}\n{}{}"
      "  model: {{block: Expression, u: [{}], expression: \"{}\"}}\nrecord: [model, y]\n"
      "fit:\n  parameters: {{{}}}\n  compare: [{{model: model, measured: y}}]\n{}",
      set.y.size() - 1, parameters, tables, table_block("y", set.y), sources,
      over_elements(models.at(set.name), set), sought, more);
}

double digits(double value, double certified) {
  if (value == certified) return 11.0;
  return std::min(11.0, -std::log10(std::abs(value - certified) / std::abs(certified)));
}

}  // namespace stepwire
