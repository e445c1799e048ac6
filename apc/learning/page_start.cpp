#include "apc/learning/page_start.h"

#include "apc/base/markup.h"

namespace apc::learning {

std::string page_start(const std::string& title) {
  const std::string shown = escaped(title);
  return "<!doctype html><html lang='en'><meta charset='utf-8'><meta name='viewport' "
         "content='width=device-width'><title>" +
         shown +
         "</title><style>:root{--bg:#fbfbf9;--ink:#18232d;--line:#d9dfe4;--mark:#566572;--model:#bd4f06;--bad:#a31621;"
         "color-scheme:light}@media (prefers-color-scheme:dark){:root{--bg:#11171d;--ink:#e6ecf1;--line:#2e3b47;"
         "--mark:#9fb0be;--model:#f59e62;--bad:#ff8078;color-scheme:dark}}@media print{:root{--bg:#fff;--ink:#111;"
         "--line:#bbb;--mark:#444;--model:#bd4f06;--bad:#a31621;color-scheme:light}svg,tr{break-inside:avoid}}"
         "body{font:16px/1.5 system-ui,sans-serif;max-width:760px;margin:2em auto;padding:0 1em;color:var(--ink);"
         "background:var(--bg);-webkit-print-color-adjust:exact;print-color-adjust:exact}"
         "svg{width:100%;font:12px system-ui}svg text{fill:var(--ink)}p,td{overflow-wrap:anywhere}"
         ".bar{fill:var(--mark)}.dots circle{fill:var(--mark)}.model{fill:none;stroke:var(--model);stroke-width:1.6}"
         ".wide{overflow-x:auto}table{border-collapse:collapse;min-width:34em}td,th{padding:2px 10px;text-align:left;"
         "border-bottom:1px solid var(--line)}"
         "</style><h1>" +
         shown + "</h1>";
}

}  // namespace apc::learning
