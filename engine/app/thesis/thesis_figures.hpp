#pragma once

#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "engine/app/session/monitor.hpp"
#include "engine/app/session/outcome.hpp"
#include "engine/view/gallery/gallery.hpp"

namespace stepwire::thesis {

/// Options of make_thesis().
struct ThesisCall {
  std::vector<std::string> only;  ///< prefixes of file names such as "fig15"; empty: all
  std::string diagrams;           ///< folder with the diagram files
  std::string out = "out/thesis";
};

/// One diagram file of the thesis, made or not.
struct ThesisFigure {
  gallery::GalleryEntry entry;
  session::Outcome outcome;  ///< outcome without its recordings
  std::exception_ptr error;  ///< reason of the failure; nullptr after success
};

/// Makes the figures, several at a time. `made` is called after each one, from any thread but never
/// concurrently.
/// Then writes the pages, and the chapters as PDF unless interrupted. Returns the entries in the order of the
/// thesis. The first page is `out`/index.html.
/// Throws EnvironmentError, and Error if no file name has a prefix in `only`.
std::vector<gallery::GalleryEntry> make_thesis(const ThesisCall& call, const Registry& registry,
                                               const session::Monitor& monitor,
                                               const std::function<void(const ThesisFigure&)>& made);

}  // namespace stepwire::thesis
