#include "apc/report/page_style.h"

namespace apc::report {

const char* const page_style = R"css(
:root{--bg:#fbfbf9;--card:#fff;--ink:#18232d;--muted:#566572;--line:#d9dfe4;--grid:#e7ebee;--foam:#e9dfc6;--foam-edge:#b9a878;
--pavement:#4b5660;--open:#fbfbf9;--tire:#dfe3e6;--nose:#0b68ad;--main:#bd4f06;--third:#25805a;--fourth:#7a4bb0;--total:#18232d;--limit:#a31621;
--good:#1e7145;--good-bg:#e3f2e8;--warn:#8a5300;--warn-bg:#fdf1dc;--bad:#a31621;--bad-bg:#fbe6e6;color-scheme:light}
@media (prefers-color-scheme:dark){:root{--bg:#11171d;--card:#18212a;--ink:#e6ecf1;--muted:#9fb0be;--line:#2e3b47;--grid:#26323d;
--foam:#443b26;--foam-edge:#8a7b52;--pavement:#9aa8b4;--open:#11171d;--tire:#33404b;--nose:#63b8f5;--main:#f59e62;--third:#6fd3a0;--fourth:#c3a1f2;
--total:#e6ecf1;--limit:#ff8078;--good:#7fd6a2;--good-bg:#173325;--warn:#f3c26b;--warn-bg:#3a2c12;--bad:#ff9a94;--bad-bg:#3d1c1e;
color-scheme:dark}}
*{box-sizing:border-box}
html{-webkit-text-size-adjust:100%}
body{margin:0;background:var(--bg);color:var(--ink);font:15px/1.5 system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",
"DejaVu Sans",Arial,sans-serif;font-variant-numeric:tabular-nums}
header,main{max-width:1240px;margin:0 auto;padding:0 20px}
header{padding-top:22px}
h1{font-size:1.55rem;line-height:1.25;margin:0 0 4px;letter-spacing:-.01em}
h2{font-size:1.12rem;margin:34px 0 10px;padding-top:12px;border-top:1px solid var(--line)}
p{margin:.4em 0;max-width:78ch}
.sub{color:var(--muted)}
.switch{position:absolute;opacity:0;pointer-events:none}
.bar-of-switches{display:flex;flex-wrap:wrap;gap:8px 20px;margin:14px 0 4px;font-size:.87rem;color:var(--muted);align-items:center}
.bar-of-switches span.group{display:inline-flex;align-items:center;gap:6px}
.bar-of-switches label{border:1px solid var(--line);padding:3px 12px;cursor:pointer;background:var(--card);color:var(--ink)}
.bar-of-switches label:first-of-type{border-radius:7px 0 0 7px}
.bar-of-switches label:last-of-type{border-radius:0 7px 7px 0;margin-left:-7px}
#units-field:checked~header label[for=units-field],#units-si:checked~header label[for=units-si],
#over-distance:checked~header label[for=over-distance],#over-time:checked~header label[for=over-time]
{background:var(--ink);color:var(--bg);border-color:var(--ink)}
.switch:focus-visible~header .bar-of-switches{outline:2px solid var(--nose);outline-offset:3px}
#units-field:checked~* .si,#units-si:checked~* .field,#over-distance:checked~* .by-time,#over-time:checked~* .by-distance{display:none}
.cards{display:grid;grid-template-columns:repeat(auto-fit,minmax(188px,1fr));gap:12px;margin:16px 0}
.card{background:var(--card);border:1px solid var(--line);border-radius:10px;padding:12px 14px}
.card b{display:block;font-size:1.42rem;line-height:1.3;letter-spacing:-.01em}
.card .label{color:var(--muted);font-size:.82rem}
.card .more{color:var(--muted);font-size:.85rem;line-height:1.4;display:block}
.good b{color:var(--good)}.warn b{color:var(--warn)}.bad b{color:var(--bad)}
.warning{background:var(--warn-bg);color:var(--warn);border-radius:8px;padding:8px 14px;margin:8px 0;max-width:none}
.wide{overflow-x:auto;-webkit-overflow-scrolling:touch}
svg{display:block;width:100%;height:auto;overflow:visible}
svg.section{min-width:760px;overflow:hidden}svg.section text{font-size:13px}
svg.rest{overflow:hidden;border:1px solid var(--line);border-radius:6px}
.plots{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,350px),1fr));gap:22px 26px}
figure{margin:0;min-width:0}
figcaption{font-size:.9rem;line-height:1.45;min-height:2.9em;display:block}
.reading{display:block;color:var(--muted);font-size:.83rem;white-space:nowrap;overflow:hidden;text-overflow:ellipsis}
.title{display:flex;flex-wrap:wrap;justify-content:space-between;gap:0 12px}.key{margin-left:10px;white-space:nowrap;font-size:.83rem}
.key svg{display:inline-block;width:22px;height:8px;margin-right:4px;vertical-align:middle}
text{font:12.5px system-ui,-apple-system,"Segoe UI",Roboto,"DejaVu Sans",Arial,sans-serif;fill:var(--ink);font-variant-numeric:tabular-nums}
.tick{fill:var(--muted);font-size:12px}.axis{fill:var(--muted);font-size:12px}
.grid{stroke:var(--grid);stroke-width:1;fill:none}.zero{stroke:var(--muted);stroke-width:1;fill:none}
.curve{fill:none;stroke-width:2;stroke-linejoin:round;stroke-linecap:round}
.curve.nose,.curve.rut-nose{stroke:var(--nose)}.curve.main,.curve.rut-main{stroke:var(--main)}
.curve.third,.curve.rut-third{stroke:var(--third)}.curve.fourth,.curve.rut-fourth{stroke:var(--fourth)}.curve.total{stroke:var(--total)}
.curve[class*=rut-]{stroke-dasharray:5 4;stroke-width:1.6}
.level{stroke-width:1.4;stroke-dasharray:7 4;fill:none}.level.limit,.level.ultimate{stroke:var(--limit)}.level.ultimate{stroke-dasharray:2 3}
.level.nose{stroke:var(--nose)}.level.main{stroke:var(--main)}.level.third{stroke:var(--third)}.level.fourth{stroke:var(--fourth)}
.level.total{stroke:var(--muted)}
.name{font-size:12px;paint-order:stroke;stroke:var(--bg);stroke-width:4px;stroke-linejoin:round}
.name.limit,.name.ultimate{fill:var(--limit)}.name.nose{fill:var(--nose)}.name.main{fill:var(--main)}.name.third{fill:var(--third)}
.name.fourth{fill:var(--fourth)}.name.total{fill:var(--muted)}
.foam{fill:var(--foam)}.surface{fill:none;stroke:var(--foam-edge);stroke-width:1.2}.pavement{fill:none;stroke:var(--pavement);stroke-width:2}
.open{fill:var(--open)}
.wheel{fill:var(--tire);stroke-width:1.6}.wheel.nose{stroke:var(--nose)}.wheel.main{stroke:var(--main)}
.wheel.third{stroke:var(--third)}.wheel.fourth{stroke:var(--fourth)}
.wheel.undeformed{fill:none;stroke:var(--muted);stroke-dasharray:3 3;stroke-width:1}
.strut{stroke:var(--ink);stroke-width:1.6;fill:none}.beam{stroke:var(--ink);stroke-width:3;stroke-linecap:round;fill:none}
.cg{fill:var(--bg);stroke:var(--ink);stroke-width:1.4}.cg-mark{fill:var(--ink)}
.stop{stroke-width:1.4;stroke-dasharray:4 3;fill:none}.stop.nose{stroke:var(--nose)}.stop.main{stroke:var(--main)}
.stop.third{stroke:var(--third)}.stop.fourth{stroke:var(--fourth)}
.grain{fill:var(--ink)}.bar{fill:none;stroke:var(--muted);stroke-width:1.2}
.cursor line{stroke:var(--muted);stroke-width:1}.cursor circle{stroke:var(--bg);stroke-width:1.5;fill:var(--ink)}
table{border-collapse:collapse;font-size:.9rem;min-width:min(100%,420px)}
th,td{padding:5px 14px 5px 0;text-align:left;vertical-align:top;border-bottom:1px solid var(--line)}
th{font-weight:600}thead th{color:var(--muted);font-weight:500;font-size:.83rem;vertical-align:bottom}
td.n,th.n{text-align:right;white-space:nowrap}tr.part th{padding-top:14px;color:var(--muted);font-weight:500;font-size:.83rem}
.rule{display:inline-block;white-space:normal;max-width:11em;font-size:.85rem;line-height:1.35}td.over{color:var(--bad);font-weight:600}td.near{color:var(--warn);font-weight:600}
.energy td.b{width:46%;min-width:120px}.energy .fill{height:12px;background:var(--nose);border-radius:2px}.energy .fill.minus{background:var(--main)}
code{font:.84rem/1.5 ui-monospace,SFMono-Regular,"DejaVu Sans Mono",Menlo,monospace;overflow-wrap:anywhere}
.two{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,480px),1fr));gap:0 44px}
footer{max-width:1240px;margin:0 auto;padding:20px 20px 40px;color:var(--muted);font-size:.85rem}
@media (max-width:560px){header,main{padding:0 16px}.cards{grid-template-columns:1fr 1fr}.card:last-child:nth-child(odd){grid-column:1/-1}
h1{font-size:1.3rem}svg.section text{font-size:17px}.reading{white-space:normal}th,td{padding-right:10px}}
@media print{@page{size:A4;margin:13mm}:root{--bg:#fff;--card:#fff;--ink:#111;--muted:#444;--line:#bbb;--grid:#ddd;--foam:#e9dfc6;
--foam-edge:#b9a878;--pavement:#4b5660;--open:#fff;--nose:#0b68ad;--main:#bd4f06;--third:#25805a;--fourth:#7a4bb0;--total:#111;--limit:#a31621;
--good:#1e7145;--warn:#8a5300;--warn-bg:#fdf1dc;--bad:#a31621;color-scheme:light}
body{font-size:9.5pt;-webkit-print-color-adjust:exact;print-color-adjust:exact}header,main,footer{max-width:none;padding-left:0;padding-right:0}
.bar-of-switches{display:none}.plots{grid-template-columns:1fr 1fr;gap:14px 20px}svg.section{min-width:0}svg.section text{font-size:17px}.wide{overflow:visible}
.cards{grid-template-columns:repeat(auto-fit,minmax(31mm,1fr));gap:6px}.card{padding:7px 9px}.card b{font-size:1.1rem}figure,.card,tr,.warning{break-inside:avoid}
h2{break-after:avoid;margin-top:16px}th,td{padding-top:3px;padding-bottom:3px}.cursor{display:none}.two{grid-template-columns:1fr}}
)css";

const char* const page_switches =
    R"html(<input class="switch" type="radio" name="units" id="units-field" checked><input class="switch" type="radio" name="units" id="units-si">
<input class="switch" type="radio" name="over" id="over-distance" checked><input class="switch" type="radio" name="over" id="over-time">
)html";

const char* const page_script = R"js(
(() => {
  const series = JSON.parse(document.getElementById('series').textContent);
  const charts = [...document.querySelectorAll('svg.chart')].map(svg => {
    const list = (name, by) => svg.dataset[name].split(by || ',');
    const caption = svg.parentNode.querySelector('.reading');
    return {svg, caption, rest: caption.innerHTML, frame: list('frame').map(Number), range: list('range').map(Number),
            factor: list('factor').map(Number), digits: list('digits').map(Number), unit: list('unit', '|'),
            curves: series.plots[+svg.dataset.plot]};
  });
  const on = id => document.getElementById(id).checked ? 1 : 0;
  const written = (value, digits) => value === null ? '-' :
    value.toLocaleString('en-US', {minimumFractionDigits: digits, maximumFractionDigits: digits});
  const nearest = (column, value) => {
    let low = 0, high = column.length - 1;
    while (high - low > 1) { const middle = (low + high) >> 1; if (column[middle] < value) low = middle; else high = middle; }
    return value - column[low] < column[high] - value ? low : high;
  };
  const clear = () => charts.forEach(c => { c.svg.querySelector('.cursor').innerHTML = ''; c.caption.innerHTML = c.rest; });
  const show = row => {
    const si = on('units-si'), column = on('over-time') ? series.time : series.distance;
    const where = (si ? written(series.distance[row], 2) + ' m' : written(series.distance[row] / 0.3048, 1) + ' ft') +
                  ', ' + written(series.time[row], 2) + ' s: ';
    for (const c of charts) {
      const [left, right, top, bottom] = c.frame, [low, high] = c.range;
      const x = left + (column[row] - column[0]) / (column[column.length - 1] - column[0]) * (right - left);
      let marks = `<line x1="${x}" x2="${x}" y1="${top}" y2="${bottom}"/>`, text = [];
      for (const curve of c.curves) {
        const value = curve.values[row];
        if (value === null) continue;
        const y = bottom - (value - low) / (high - low) * (bottom - top);
        marks += `<circle cx="${x}" cy="${y}" r="4" style="fill:var(--${curve.look.replace('rut-', '')})"/>`;
        text.push((c.curves.length > 1 ? curve.name + ' ' : '') + written(value / c.factor[si], c.digits[si]));
      }
      c.svg.querySelector('.cursor').innerHTML = marks;
      c.caption.textContent = where + text.join(' · ') + ' ' + c.unit[si];
    }
  };
  for (const c of charts) {
    c.svg.addEventListener('pointermove', event => {
      const box = c.svg.getBoundingClientRect(), [left, right] = c.frame;
      const x = (event.clientX - box.left) / box.width * c.svg.viewBox.baseVal.width;
      if (x < left - 8 || x > right + 8) return clear();
      const column = on('over-time') ? series.time : series.distance;
      show(nearest(column, column[0] + (x - left) / (right - left) * (column[column.length - 1] - column[0])));
    });
    c.svg.addEventListener('pointerleave', clear);
  }
  document.querySelectorAll('.switch').forEach(input => input.addEventListener('change', clear));
  document.body.dataset.ready = '1';
})();
)js";

}  // namespace apc::report
