#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/analyse/statistics/observations.hpp"

namespace stepwire::textbook {

/// Levels of a factor that runs through `count` levels, each `each` times, over and over up to `size`.
inline statistics::Factor running(const std::string& name, std::size_t count, std::size_t each,
                                  std::size_t size, bool subject = false) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < size; ++i) words.push_back(std::to_string(i / each % count + 1));
  return statistics::make_factor(name, words, subject);
}

/// Hours of sleep gained with two drugs (Student 1908); R: datasets::sleep.
inline statistics::Observations sleep() {
  return {
      "extra",
      {0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0, 2, 1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4},
      {running("group", 2, 10, 20), running("ID", 10, 1, 20, true)}};
}

/// Effort to rise from four stools; R: nlme::ergoStool, ordered by Subject and Type.
inline statistics::Observations stools() {
  return {"effort",
          {7,  11, 8, 7,  8,  11, 8, 7,  7,  11, 10, 9,  9,  13, 10, 8,  9,  11,
           11, 10, 7, 14, 13, 9,  8, 12, 12, 11, 12, 15, 12, 10, 10, 14, 13, 12},
          {running("Type", 4, 1, 36), running("Subject", 9, 4, 36, true)}};
}

/// Yields of oats, a split plot (Yates 1935); R: MASS::oats, ordered by B, V and N.
inline statistics::Observations oats() {
  return {"Y",
          {117, 114, 161, 141, 105, 140, 118, 156, 111, 130, 157, 174, 70,  108, 126, 149, 96,  124,
           121, 144, 61,  91,  97,  100, 60,  102, 89,  96,  89,  129, 132, 124, 68,  64,  112, 86,
           64,  103, 132, 133, 70,  89,  104, 117, 74,  89,  81,  122, 80,  82,  94,  126, 63,  70,
           109, 99,  62,  90,  100, 116, 89,  82,  86,  104, 97,  99,  119, 121, 53,  74,  118, 113},
          {running("N", 4, 1, 72), running("V", 3, 4, 72), running("B", 6, 12, 72, true)}};
}

/// Yields of peas over nitrogen, phosphate and potash in blocks of four; R: datasets::npk.
inline statistics::Observations peas() {
  const auto digits = [](const std::string& name, const std::string& text, bool subject = false) {
    std::vector<std::string> words;
    for (const char c : text) words.emplace_back(1, c);
    return statistics::make_factor(name, words, subject);
  };
  return {"yield",
          {49.5, 62.8, 46.8, 57,   59.8, 58.5, 55.5, 56,   62.8, 55.8, 69.5, 55,
           62,   48.8, 45.5, 44.2, 52,   51.5, 49.8, 48.8, 57.2, 59,   53.2, 56},
          {digits("N", "010111000110110010101100"), digits("P", "110001011100010110010110"),
           digits("K", "100101100101011000111010"), digits("block", "111122223333444455556666", true)}};
}

/// Breaks of yarn over wool and tension; R: datasets::warpbreaks.
inline statistics::Observations warps() {
  return {"breaks",
          {26, 30, 54, 25, 70, 52, 51, 26, 67, 18, 21, 29, 17, 12, 18, 35, 30, 36,
           36, 21, 24, 18, 10, 43, 28, 15, 26, 27, 14, 29, 19, 29, 31, 41, 20, 44,
           42, 26, 19, 16, 39, 28, 21, 39, 29, 20, 21, 24, 17, 13, 15, 15, 16, 28},
          {running("wool", 2, 27, 54), running("tension", 3, 9, 54)}};
}

/// The same without the rows 1, 2, 20, 33 and 54, so that its cells differ in size.
inline statistics::Observations unequal_warps() {
  statistics::Observations all = warps(), some{all.response, {}, all.factors};
  for (statistics::Factor& factor : some.factors) factor.level.clear();
  for (std::size_t i = 0; i < all.values.size(); ++i) {
    if (i == 0 || i == 1 || i == 19 || i == 32 || i == 53) continue;
    some.values.push_back(all.values[i]);
    for (std::size_t k = 0; k < all.factors.size(); ++k)
      some.factors[k].level.push_back(all.factors[k].level[i]);
  }
  return some;
}

/// Growth of teeth over supplement and dose; R: datasets::ToothGrowth.
inline statistics::Observations teeth() {
  return {"len",
          {4.2,  11.5, 7.3,  5.8,  6.4,  10,   11.2, 11.2, 5.2,  7,    16.5, 16.5, 15.2, 17.3, 22.5,
           17.3, 13.6, 14.5, 18.8, 15.5, 23.6, 18.5, 33.9, 25.5, 26.4, 32.5, 26.7, 21.5, 23.3, 29.5,
           15.2, 21.5, 17.6, 9.7,  14.5, 10,   8.2,  9.4,  16.5, 9.7,  19.7, 23.3, 23.6, 26.4, 20,
           25.2, 25.8, 21.2, 14.5, 27.3, 25.5, 26.4, 22.4, 24.5, 24.8, 30.9, 26.4, 27.3, 29.4, 23},
          {running("supp", 2, 30, 60), running("dose", 3, 10, 60)}};
}

}  // namespace stepwire::textbook
