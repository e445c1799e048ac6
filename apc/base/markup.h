/// Text that stands in HTML, SVG or XML as it was written.
#pragma once

#include <string>

namespace apc {

/// `text` with & < > " ' as entities: whatever a user wrote, it is shown and never read as markup.
std::string escaped(const std::string& text);

}  // namespace apc
