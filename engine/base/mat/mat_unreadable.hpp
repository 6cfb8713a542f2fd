#pragma once

#include <string>

namespace stepwire::mat {

/// Kinds of variables that are no columns of real numbers.
enum class MatUnreadable { complex, sparse, cell, function, object, struct_array };

/// A sentence for people that names the variable and what to do in MATLAB, where `name` is an expression:
/// "'z' is complex; in MATLAB: `re = real(z); im = imag(z); save('f.mat', 't', 're', 'im', '-v7')`".
/// `class_name` is that of an object.
std::string unreadable_text(const std::string& name, MatUnreadable kind, const std::string& class_name = "");

}  // namespace stepwire::mat
