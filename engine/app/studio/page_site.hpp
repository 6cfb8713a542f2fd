#pragma once

#include <span>
#include <string>

#include "engine/app/studio/http/message.hpp"
#include "engine/app/studio/page_table.hpp"

namespace stepwire::studio {

/// The answer to a request for a file of the page: that of the table with this very path, or 404.
http::Answer page_answer(std::span<const PageFile> table, const http::Request& request,
                         const std::string& path);

}  // namespace stepwire::studio
