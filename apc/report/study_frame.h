/// What every page of a study, a design or a compliance report has around it: head, style, the switch of units, foot.
#pragma once

#include <string>
#include <vector>

#include "apc/report/page_parts.h"
#include "apc/report/record.h"

namespace apc::report {

/// `header` stands above the switch (title, outcome), `body` below it; both HTML.
std::string framed(const std::string& title, const std::string& header, const std::string& body,
                   const std::string& foot);

/// A table of HTML cells in a box that scrolls sideways on a phone. Columns from the second on stand right when
/// `numbers`; lists of `files` keep paths and hashes in one line.
enum class Cells { text, numbers, files };
std::string table(const std::vector<std::string>& headings, const std::vector<std::vector<std::string>>& rows, Cells);

/// Version, command and input files with their hashes.
std::string manifest_section(const Manifest&);

}  // namespace apc::report
