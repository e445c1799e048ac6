#include "apc/cli/print_pdf.h"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "apc/base/file.h"
#include "apc/base/require.h"

namespace apc::cli {
namespace fs = std::filesystem;

fs::path find_browser() {
  for (const char* path : {"/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"})
    if (std::error_code error; fs::exists(path, error)) return path;
  throw InputError(
      "--pdf: no Chromium is installed. Install the package \"chromium\", or print report.html from any browser");
}

namespace {

std::string for_shell(const fs::path& path) {
  std::string out = "'";
  for (const char letter : path.string()) out += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return out + "'";
}

/// "D:20260131120000+00'00'" becomes "D:20000101000000+00'00'": as long as before, so that every offset in the file
/// stays right.
std::string without_dates(std::string pdf) {
  for (const char* name : {"/CreationDate (D:", "/ModDate (D:"})
    for (auto at = pdf.find(name); at != std::string::npos; at = pdf.find(name, at + 1)) {
      const std::string date = "20000101000000";
      auto digit = at + std::string(name).size();
      for (std::size_t i = 0; i < date.size() && digit < pdf.size() && std::isdigit(pdf[digit]); ++i, ++digit)
        pdf[digit] = date[i];
    }
  return pdf;
}

}  // namespace

void print_pdf(const fs::path& browser, const fs::path& page, const fs::path& pdf) {
  const auto own = fs::temp_directory_path() / ("apc_print_" + std::to_string(::getpid()));
  const auto made = own / "page.pdf";
  fs::create_directories(own);
  const auto command = for_shell(browser) +
                       " --headless --no-sandbox --disable-gpu --no-first-run --disable-background-networking"
                       " --disable-component-update --disable-sync --no-pdf-header-footer --virtual-time-budget=3000 "
                       "--user-data-dir=" +
                       for_shell(own / "profile") + " --print-to-pdf=" + for_shell(made) + " " +
                       for_shell("file://" + fs::absolute(page).string()) + " >/dev/null 2>&1 </dev/null";
  const int code = std::system(command.c_str());
  std::error_code error;
  const bool printed = code == 0 && fs::exists(made, error);
  const auto text = printed ? without_dates(read_text(made)) : std::string();
  fs::remove_all(own, error);
  require(printed, "--pdf: ", browser.string(), " did not print ", page.string(), ". Print it by hand");
  write_text(pdf, text);
}

}  // namespace apc::cli
