/// A page as PDF, printed by an installed Chromium.
#pragma once

#include <filesystem>

namespace apc::cli {

/// InputError when none is installed: says which package to install.
std::filesystem::path find_browser();

/// Chromium's own print of `page`; nothing of the page's content passes through a shell. The dates that Chromium writes
/// into the file are set to 2000-01-01, so that the same page gives the same bytes. InputError when nothing was
/// printed.
void print_pdf(const std::filesystem::path& browser, const std::filesystem::path& page,
               const std::filesystem::path& pdf);

}  // namespace apc::cli
