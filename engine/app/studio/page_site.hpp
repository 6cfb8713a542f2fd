#pragma once

#include <span>
#include <string>

#include "engine/app/studio/http/message.hpp"
#include "engine/app/studio/page_table.hpp"

namespace stepwire::studio {

/// Returns the file of the page whose path is exactly `path`, or 404.
http::Answer page_answer(std::span<const PageFile> table, const http::Request& request,
                         const std::string& path);

}  // namespace stepwire::studio
