#include "apc/report/study_frame.h"

#include <fmt/format.h>

#include "apc/report/page_style.h"
#include "apc/report/svg.h"

namespace apc::report {
namespace {

const char* const more_style = R"css(
.dot{stroke:none}.dot.nose,.dot.rut-nose{fill:var(--nose)}.dot.main,.dot.rut-main{fill:var(--main)}.dot.third,.dot.rut-third{fill:var(--third)}
.dot.fourth,.dot.rut-fourth{fill:var(--fourth)}.dot.total,.dot.rut-total{fill:var(--total)}.curve.rut-total{stroke:var(--total)}
.curve.limit{stroke:var(--limit);stroke-dasharray:7 4}figure.plot .reading{white-space:normal}tbody th{white-space:nowrap}
.ring{fill:none;stroke:var(--limit);stroke-width:1.6}
.tornado.low{fill:var(--nose)}.tornado.high{fill:var(--main)}
figure.plot{max-width:640px}table.files td{white-space:nowrap}table.files code{overflow-wrap:normal}
table.files td:last-child{white-space:normal;min-width:17em}.range{display:block;color:var(--muted);font-size:.83em}
.keys{display:block;font-size:.83rem}.keys .key:first-child{margin-left:0}
td.pass{color:var(--good);font-weight:600}td.fail{color:var(--bad);font-weight:600}td.open{color:var(--warn);font-weight:600}
tr.total th,tr.total td{border-top:2px solid var(--line)}.wrap{white-space:normal}
.tag{display:inline-block;border:1px solid var(--line);border-radius:6px;padding:0 6px;font-size:.8rem;color:var(--muted);white-space:nowrap}
.tag.open{color:var(--warn);border-color:var(--warn)}.tag.good{color:var(--good);border-color:var(--good)}.tag.bad{color:var(--bad);border-color:var(--bad)}
svg.plan{min-width:720px}svg.plan text{font-size:13px}
.area{fill:none;stroke:var(--muted);stroke-dasharray:6 4}.runway{fill:var(--pavement);opacity:.35}.plan-bed{fill:var(--foam);stroke:var(--foam-edge)}
@media (max-width:560px){figure.plot svg text{font-size:14px}svg.plan text{font-size:17px}
.requirements thead{display:none}.requirements tr{display:block;padding:9px 0;border-bottom:1px solid var(--line)}
.requirements th,.requirements td{display:block;border:0;padding:1px 0}}
@media print{.wide table{font-size:7.5pt;width:100%;min-width:0}.wide th,.wide td,.wide td.n,.wide th.n,table.files td,.wide tbody th{white-space:normal;padding-right:6px}
.wide code{font-size:6.5pt;overflow-wrap:anywhere}.tag{white-space:normal;font-size:6.5pt}.rule{max-width:none}svg.plan{min-width:0}.reading{white-space:normal}
table.files td:last-child{min-width:0}
thead{display:table-header-group}section{break-inside:auto}}
)css";

}  // namespace

std::string framed(const std::string& title, const std::string& header, const std::string& body,
                   const std::string& foot) {
  std::string out =
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width,initial-scale=1\"><link rel=\"icon\" href=\"data:,\"><title>" +
      escaped(title) + "</title><style>" + page_style + more_style + "</style></head>\n<body>\n" + page_switches;
  out += "<header>" + header +
         "<div class=\"bar-of-switches\"><span class=\"group\">Units <label for=\"units-field\">field</label>"
         "<label for=\"units-si\">SI</label></span></div>\n</header>\n<main>\n" +
         body + "</main>\n<footer>" + foot + "</footer>\n";
  return out + "<script>document.body.dataset.ready='1'</script>\n</body></html>\n";
}

std::string table(const std::vector<std::string>& headings, const std::vector<std::vector<std::string>>& rows,
                  Cells cells) {
  const char* look = cells == Cells::numbers ? " class=\"n\"" : "";
  std::string out = cells == Cells::files ? "<div class=\"wide\"><table class=\"files\"><thead><tr>"
                                          : "<div class=\"wide\"><table><thead><tr>";
  for (std::size_t i = 0; i < headings.size(); ++i) out += fmt::format("<th{}>{}</th>", i ? look : "", headings[i]);
  out += "</tr></thead><tbody>\n";
  for (const auto& row : rows) {
    out += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      // A cell may bring its own class: "@fail|text".
      const auto bar = row[i].starts_with("@") ? row[i].find('|') : std::string::npos;
      const auto mood = bar == std::string::npos ? std::string() : row[i].substr(1, bar - 1);
      const auto text = bar == std::string::npos ? row[i] : row[i].substr(bar + 1);
      if (i == 0)
        out += "<th>" + text + "</th>";
      else
        out += fmt::format("<td class=\"{}{}\">{}</td>", cells == Cells::numbers ? "n " : "", mood, text);
    }
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

std::string manifest_section(const Manifest& manifest) {
  std::vector<std::vector<std::string>> rows;
  for (const auto& file : manifest.files)
    rows.push_back({escaped(file.role), "<code>" + escaped(file.path) + "</code>",
                    "<code>" + file.sha256.substr(0, 16) + "…</code>", escaped(file.source)});
  return "<p>" + escaped(manifest.version) + (manifest.date.empty() ? "" : ", " + escaped(manifest.date)) + ": <code>" +
         escaped(manifest.command) + "</code></p>\n" +
         table({"input", "file", "SHA-256", "source"}, rows, Cells::files);
}

}  // namespace apc::report
