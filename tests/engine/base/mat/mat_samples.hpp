#pragma once

#include <matio.h>

#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <string>

namespace stepwire::testing {

/// A file as the library writes it: a column, a row, a matrix, integers, and what is no real vector.
inline void write_by_library(const std::string& path, mat_ft version) {
  mat_t* const file = Mat_CreateVer(path.c_str(), nullptr, version);
  REQUIRE(file);
  const auto put = [&](const char* name, matio_classes type, matio_types of, std::size_t rows,
                       std::size_t columns, void* data, int flags = 0) {
    std::array<std::size_t, 2> size{rows, columns};
    matvar_t* const variable = Mat_VarCreate(name, type, of, 2, size.data(), data, flags);
    CHECK(Mat_VarWrite(file, variable,
                       version == MAT_FT_MAT5 ? MAT_COMPRESSION_ZLIB : MAT_COMPRESSION_NONE) == 0);
    Mat_VarFree(variable);
  };
  std::array<double, 6> doubles{1.5, 2.5, 3.5, 4.5, 5.5, 6.5};
  std::array<std::int16_t, 2> integers{-3, 300};
  std::array<float, 1> single{0.25f};
  mat_complex_split_t complex{doubles.data(), doubles.data()};
  put("column", MAT_C_DOUBLE, MAT_T_DOUBLE, 3, 1, doubles.data());
  put("row", MAT_C_DOUBLE, MAT_T_DOUBLE, 1, 3, doubles.data());
  put("matrix", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, 3, doubles.data());
  put("text", MAT_C_CHAR, MAT_T_UINT8, 1, 5, const_cast<char*>("words"));
  put("complex", MAT_C_DOUBLE, MAT_T_DOUBLE, 3, 1, &complex, MAT_F_COMPLEX);
  if (version != MAT_FT_MAT4) put("integers", MAT_C_INT16, MAT_T_INT16, 1, 2, integers.data());
  if (version != MAT_FT_MAT4) put("single", MAT_C_SINGLE, MAT_T_SINGLE, 1, 1, single.data());
  Mat_Close(file);
}

}  // namespace stepwire::testing
