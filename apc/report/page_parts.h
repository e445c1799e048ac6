/// What the pages of different runs share: their beginning and end, cards, table rows, the numbers behind the plots.
#pragma once

#include <string>
#include <vector>

#include "apc/report/plot.h"
#include "apc/report/record.h"

namespace apc::report {

/// Everything up to and with the switches in the body; the caller goes on with <header>.
std::string page_head(const std::string& title);
/// Series, script and the end of the document.
std::string page_end(const std::string& series);

/// The visible half of the switches for units and axis; belongs into <header>.
std::string switches_bar();

/// A key figure; `mood` is "good", "warn", "bad" or empty, `value` and `more` are HTML.
std::string card(const std::string& mood, const std::string& label, const std::string& value, const std::string& more);

/// A table row of a heading and one cell, both HTML.
std::string row(const std::string& name, const std::string& value);
std::string file_row(const InputFile&);

/// The numbers behind the plots as JSON, for the cross-hair. Holds names and numbers only, so that no text of a file
/// can end the script early.
std::string series(const std::vector<Plot>&, const Abscissa&);
std::string no_series();

}  // namespace apc::report
