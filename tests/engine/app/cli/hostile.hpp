#pragma once

#include <string>
#include <vector>

/// Texts that would be code, markup or commands of a terminal where they are not escaped. Those that run
/// would create the file "executed".
inline std::vector<std::string> hostile_texts() {
  const std::string run =
      "__attribute__((constructor)) static void x() { __builtin_system(\"touch executed\"); }";
  return {"two\nlines",
          "a\n#include <cstdlib>\n" + run + "\n//",
          "a\r" + run + "\r//",
          "*/ " + run + " /*",
          "ends with a backslash \\",
          "ends with a backslash and blanks \\  ",
          "trigraph ?\?/",
          "\"); system(\"touch executed\"); (\"",
          "')\n!touch executed\nset label '",
          "`touch executed` $(touch executed) ; touch executed",
          "$(shell touch executed) ${CMAKE_BINARY_DIR} %g %s {/Symbol a} @x",
          "<script>alert(1)</script> & \"quotes\" 'and' ]]> -->",
          "\x1b[2Jcleared \x07 \x7f",
          "right \u202e to left \u2066 and \u2028 lines \u0085",
          std::string("nul \0 inside", 12),
          "größe – µ \U0001F600"};
}
