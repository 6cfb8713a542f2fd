// Sums, gains and products of Simulink.
#include <fmt/format.h>

#include <algorithm>

#include "engine/app/simulink/forms.hpp"

namespace stepwire::simulink {
namespace {

/// Returns the signs of a Sum or Product: "+-" of "|+-", "++" of "2".
std::string signs_of(const BlockWriter& write, char all) {
  const std::string text = write.text("Inputs", std::string(2, all));
  std::string signs;
  for (const char c : text)
    if (c == '+' || c == '-' || c == '*' || c == '/') signs += c;
  if (!signs.empty()) return signs;
  const double count = write.known("Inputs", "2");
  if (!(count >= 1.0 && count <= 1000.0)) throw Untranslated("its number of inputs is " + text);
  return std::string(static_cast<std::size_t>(count), all);
}

void sum(BlockWriter& write) {
  const std::string signs = signs_of(write, '+');
  if (signs.size() == 1 && write.width(1) != 1) {
    require(write, "CollapseMode", "All dimensions");
    write.make("Dot").key("u", list_of({word(write.source()), word(signs == "-" ? "-1" : "1")}));
    return;
  }
  std::vector<yaml::Node> sources;
  for (std::size_t i = 1; i <= signs.size(); ++i) sources.push_back(word(write.source(static_cast<int>(i))));
  write.make("Sum").key("signs", quoted(signs)).key("u", list_of(std::move(sources))).every();
}

void gain(BlockWriter& write) {
  const Value gain = write.finite("Gain", "1");
  const std::string kind = write.text("Multiplication", "Element-wise(K.*u)");
  const bool by_element = kind.starts_with("Element-wise");
  if (gain.is_scalar() || (by_element && gain.is_vector())) {
    write.make("Gain").u().key("gain", gain).every();
    return;
  }
  if (by_element) throw Untranslated("its gain is a matrix that multiplies element by element");
  if (kind == "Matrix(u*K)")
    throw Untranslated("its gain is multiplied from the right; a Transpose and a MatrixGain do that");
  write.make("MatrixGain").u().key("gain", rows_node(gain)).every();
}

/// Returns the product of sources: the source itself, or a further block.
yaml::Node product_of(BlockWriter& write, const std::string& suffix, std::vector<yaml::Node> factors) {
  if (factors.empty()) return word("1");
  if (factors.size() == 1) return factors[0];
  return word(write.extra(suffix, block_node("Product", {{"u", list_of(std::move(factors))}})));
}

void matrix_product(BlockWriter& write, const std::string& signs) {
  std::vector<std::string> factors;
  for (std::size_t i = 0; i < signs.size(); ++i) {
    const std::string source = write.source(static_cast<int>(i + 1));
    const std::string number = std::to_string(i + 1);
    factors.push_back(signs[i] == '/'
                          ? write.extra("inverse_" + number, block_node("Inverse", {{"u", word(source)}}))
                          : source);
  }
  std::string left = factors[0];
  for (std::size_t i = 1; i + 1 < factors.size(); ++i)
    left = write.extra("product_" + std::to_string(i),
                       block_node("MatrixMultiply", {{"a", word(left)}, {"b", word(factors[i])}}));
  if (factors.size() == 1) throw Untranslated("it has one input and multiplies matrices");
  write.make("MatrixMultiply").key("a", left).key("b", factors.back()).every();
}

void product(BlockWriter& write) {
  const std::string signs = signs_of(write, '*');
  if (write.text("Multiplication", "Element-wise(.*)").starts_with("Matrix"))
    return matrix_product(write, signs);
  if (signs.size() == 1 && write.width(1) != 1)
    throw Untranslated("it multiplies the elements of one input, whose number does not follow from the file");
  std::vector<yaml::Node> over, under;
  for (std::size_t i = 0; i < signs.size(); ++i)
    (signs[i] == '/' ? under : over).push_back(word(write.source(static_cast<int>(i + 1))));
  if (under.empty()) {
    write.make("Product").key("u", list_of(std::move(over))).every();
    return;
  }
  yaml::Node numerator = product_of(write, "numerator", std::move(over));
  yaml::Node denominator = product_of(write, "denominator", std::move(under));
  write.make("Divide")
      .key("numerator", std::move(numerator))
      .key("denominator", std::move(denominator))
      .every();
}

void bias(BlockWriter& write) {
  yaml::Node added = constant_source(write, "bias", write.finite("Bias", "0"));
  write.make("Sum").key("u", list_of({word(write.source()), std::move(added)}));
}

void minus(BlockWriter& write) {
  write.make("Gain").u().key("gain", "-1");
}

void slider_gain(BlockWriter& write) {
  write.make("Gain").u().key("gain", "gain", "1");
}

void dot(BlockWriter& write) {
  write.make("Dot").key("u", list_of(write.sources()));
}

void min_max(BlockWriter& write) {
  const int count = write.inputs();
  if (count < 2 && write.width(1) != 1)
    throw Untranslated("it compares the elements of one input; give them to a MinMax one by one");
  write.make("MinMax")
      .key("function", write.text("Function", "min"))
      .key("u", list_of(write.sources()))
      .every();
}

void absolute(BlockWriter& write) {
  write.make("Abs").u().every();
}

void sign(BlockWriter& write) {
  write.make("Sign").u().every();
}

void polynomial(BlockWriter& write) {
  const char* name = write.text("Coefs").empty() ? "coefs" : "Coefs";
  write.make("Polynomial").u().key("coefficients", list_node(write.finite(name, "[1]")));
}

}  // namespace

std::vector<Translation> math_translations() {
  return {{"Sum", "`Sum`; of one vector `Dot`", sum},
          {"Gain", "`Gain`, `MatrixGain`", gain},
          {"Product", "`Product`, `Divide`, `MatrixMultiply`, `Inverse`", product},
          {"Bias", "`Sum`", bias},
          {"UnaryMinus", "`Gain` of -1", minus},
          {"Slider Gain", "`Gain`", slider_gain},
          {"DotProduct", "`Dot`", dot},
          {"MinMax", "`MinMax`", min_max},
          {"Abs", "`Abs`", absolute},
          {"Signum", "`Sign`", sign},
          {"Polyval", "`Polynomial`", polynomial}};
}

}  // namespace stepwire::simulink
