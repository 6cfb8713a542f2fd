#pragma once

#include <stepwire/stepwire.hpp>

namespace sw = stepwire;

/// The cart with the consumer's own block.
sw::Model cart(const sw::NamedTexts& settings = {});

void check(bool holds, const char* what, int line);
#define CHECK(condition) check(condition, #condition, __LINE__)

/// Returns the message of the Error that the call throws; an empty text if it throws none.
template <class Call>
std::string refusal(Call call) {
  try {
    call();
    return "";
  } catch (const sw::Error& error) {
    return error.what();
  }
}

inline bool contains(const std::string& text, const std::string& piece) {
  return text.find(piece) != text.npos;
}

void check_model();
void check_steps();
void check_values();
void check_snapshots();
void check_observers();
void check_sweep();
void check_compiled();
