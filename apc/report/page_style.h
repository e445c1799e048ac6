/// Style sheet and script of every page; both stand inside the page, nothing is fetched.
#pragma once

namespace apc::report {

extern const char* const page_style;

/// The switches for units and axis, as hidden inputs that must stand before <header> in the body: the style sheet reads
/// them, so they work without the script.
extern const char* const page_switches;

/// Adds the cross-hair to every plot and keeps the switches' setting. Reads <script id="series">.
extern const char* const page_script;

}  // namespace apc::report
