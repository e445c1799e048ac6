/// The beginning of the pages about learning: one style for phone, desk, dark and paper.
#pragma once

#include <string>

namespace apc::learning {

/// Document, style and heading; `title` as the user wrote it. The caller closes with "</html>".
std::string page_start(const std::string& title);

}  // namespace apc::learning
