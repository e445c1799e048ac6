/// Pages seen by a real browser: Debian's Chromium lays each one out for a phone, a desk and paper, in light or dark,
/// and says what it measured.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "tests/scenarios/program.h"

namespace apc::browser {

inline std::filesystem::path chromium() {
  for (const char* path : {"/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"})
    if (std::filesystem::exists(path)) return path;
  return {};
}

/// What one page looked like at one width.
struct View {
  std::string name;                   ///< "phone", "desk", "paper"
  double overflow = 0.0;              ///< px by which the page is wider than the window
  std::vector<std::string> flat;      ///< pictures without size, curves without a path
  std::vector<std::string> hidden;    ///< headings, figures and tables that take no room
  std::vector<std::string> cut;       ///< tables and pictures that reach beyond the window (on paper: lost)
  std::vector<std::string> overlaps;  ///< words of a picture that lie on each other
  double contrast = 0.0;              ///< of text on its ground, 1 to 21
  double brightness = 0.0;            ///< of the ground, 0 to 1
  int pictures = 0;
};

struct Look {
  std::vector<View> views;
  std::vector<std::string> complaints;  ///< lines of the browser's console
};

/// The script that measures. It lies in a page of its own, which holds the page in question in frames of each width:
/// window sizes have a least width, frames have none.
inline const char* const measuring_page =
    R"html(<!doctype html><meta charset="utf-8"><body style="margin:0"><pre id="said"></pre><script>
const luminance = colour => {
  const [r, g, b] = colour.match(/[\d.]+/g).slice(0, 3).map(part => {
    const c = part / 255;
    return c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
};
const name_of = e => `${e.tagName.toLowerCase()} "${(e.getAttribute('aria-label') || e.textContent || '').trim().slice(0, 40)}"`;
const alternative = e => {  // the other unit system, the other abscissa, what only speaks to machines
  for (; e && e.nodeType === 1; e = e.parentElement)
    if (e.ownerDocument.defaultView.getComputedStyle(e).display === 'none' &&
        /\b(si|field|by-time|by-distance|bar-of-switches|cursor)\b/.test(e.getAttribute('class') || '')) return true;
  return false;
};
function measure(frame, name, width) {
  const doc = frame.contentDocument, view = frame.contentWindow, root = doc.documentElement;
  if (name === 'paper')
    for (const sheet of doc.styleSheets)
      for (const rule of sheet.cssRules) if (rule.media && rule.media.mediaText === 'print') rule.media.mediaText = 'all';
  const seen = e => { const box = e.getBoundingClientRect(); return box.width > 0 && box.height > 0; };
  const all = query => [...doc.querySelectorAll(query)].filter(e => !alternative(e));
  const out = {name, overflow: root.scrollWidth - root.clientWidth, flat: [], hidden: [], cut: [], overlaps: []};
  const pictures = all('svg[role=img]');
  out.pictures = pictures.length;
  for (const picture of pictures) {
    const box = picture.getBoundingClientRect();
    if (box.width < 60 || box.height < 40) out.flat.push(name_of(picture));
    const words = [...picture.querySelectorAll('text')].filter(e => !alternative(e) && seen(e));
    words.forEach((one, i) => words.slice(i + 1).forEach(other => {
      const a = one.getBoundingClientRect(), b = other.getBoundingClientRect();
      const wide = Math.min(a.right, b.right) - Math.max(a.left, b.left);
      const tall = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
      if (wide > 2 && tall > 0.45 * Math.min(a.height, b.height))
        out.overlaps.push(`${picture.getAttribute('aria-label')}: ${one.textContent} / ${other.textContent}`);
    }));
  }
  for (const curve of all('svg[role=img] path.curve'))
    if ((curve.getAttribute('d') || '').length < 4) out.flat.push('curve ' + curve.getAttribute('class'));
  for (const part of all('h1,h2,figure,table,.card')) if (!seen(part)) out.hidden.push(name_of(part));
  for (const part of all('table,svg[role=img],figure,.card')) {
    const scrolls = name !== 'paper' && part.closest('.wide');
    if (!scrolls && part.getBoundingClientRect().right > width + 1) out.cut.push(name_of(part));
  }
  const style = view.getComputedStyle(doc.body), ground = luminance(style.backgroundColor), ink = luminance(style.color);
  out.brightness = ground;
  out.contrast = (Math.max(ground, ink) + 0.05) / (Math.min(ground, ink) + 0.05);
  return out;
}
const views = [];
const next = list => {
  if (!list.length) { document.getElementById('said').textContent = 'SAID' + JSON.stringify(views) + 'END'; return; }
  const [name, width] = list[0], frame = document.createElement('iframe');
  frame.style.cssText = `width:${width}px;height:1000px;border:0`;
  frame.onload = () => { views.push(measure(frame, name, frame.contentDocument.documentElement.clientWidth)); frame.remove(); next(list.slice(1)); };
  frame.src = 'PAGE';
  document.body.append(frame);
};
next([['phone', 390], ['desk', 1400], ['paper', 696]]);
</script>)html";

inline std::string unescaped(std::string text) {
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"&lt;", "<"},
                                 {"&gt;", ">"},
                                 {"&quot;", "\""},
                                 {"&nbsp;", " "},
                                 {"&amp;", "&"}})
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
  return text;
}

/// Opens `page` (below the folder) and measures. Fails the test when the browser says nothing.
inline Look look(const scenarios::Folder& folder, const std::string& page, bool dark) {
  const auto own = folder.path() / "browser";
  std::filesystem::create_directories(own);
  auto html = std::string(measuring_page);
  html.replace(html.find("'PAGE'"), 6, "'file://" + (folder.path() / page).string() + "'");
  std::ofstream(own / "measure.html") << html;
  const auto command =
      chromium().string() +
      " --headless --no-sandbox --disable-gpu --no-first-run --disable-background-networking"
      " --disable-component-update --disable-sync --allow-file-access-from-files --window-size=1500,1100"
      " --enable-logging=stderr --virtual-time-budget=20000 --blink-settings=preferredColorScheme=" +
      std::string(dark ? "0" : "1") + " --user-data-dir='" + (own / "profile").string() + "' --dump-dom 'file://" +
      (own / "measure.html").string() + "' >'" + (own / "dom").string() + "' 2>'" + (own / "log").string() +
      "' </dev/null";
  Look out;
  const int code = std::system(command.c_str());
  const auto dom = scenarios::text_of(own / "dom"), log = scenarios::text_of(own / "log");
  // The script's own text holds 'SAID' as well; what it said begins with a bracket.
  const auto from = dom.find("SAID["), to = dom.find("]END", from);
  if (code != 0 || from == std::string::npos || to == std::string::npos) {
    ADD_FAILURE() << "the browser said nothing about " << page << " (code " << code << ")\n" << log.substr(0, 2000);
    return out;
  }
  for (const auto& each : nlohmann::json::parse(unescaped(dom.substr(from + 4, to - from - 3)))) {
    View view;
    view.name = each["name"], view.overflow = each["overflow"], view.pictures = each["pictures"];
    view.flat = each["flat"], view.hidden = each["hidden"], view.cut = each["cut"], view.overlaps = each["overlaps"];
    view.contrast = each["contrast"], view.brightness = each["brightness"];
    out.views.push_back(view);
  }
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);)
    if (line.find("CONSOLE") != std::string::npos) out.complaints.push_back(line);
  return out;
}

}  // namespace apc::browser
