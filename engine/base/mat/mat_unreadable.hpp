#pragma once

#include <string>

namespace stepwire::mat {

/// Kinds of variables that cannot become columns of real numbers.
enum class MatUnreadable { complex, sparse, cell, function, object, struct_array };

/// Returns a message with the variable and the cure in MATLAB, where `name` is an expression.
/// `class_name` is that of an object. Example:
///   'z' is complex; save numbers in MATLAB: `re = real(z); im = imag(z); save('f.mat', ...)`
std::string unreadable_text(const std::string& name, MatUnreadable kind, const std::string& class_name = "");

}  // namespace stepwire::mat
