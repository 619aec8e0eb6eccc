#pragma once

namespace flownav {

/// Style sheet of report.html.
inline const char* const report_style = R"css(
body { font: 16px/1.5 system-ui, "DejaVu Sans", Arial, sans-serif; color: #1e1e1e; background: #fff;
       max-width: 960px; margin: 0 auto; padding: 24px 20px 48px; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0 0 .8rem; overflow-wrap: anywhere; }
h2 { font-size: 1.2rem; margin: 2.4rem 0 .7rem; padding-bottom: .2rem; border-bottom: 1px solid #ccc; }
p { max-width: 75ch; margin: .6rem 0; }
.good, .bad { max-width: none; padding: .5rem .8rem; border-left: 5px solid #009e73; background: #eef8f4; overflow-wrap: anywhere; }
.bad { border-color: #d55e00; background: #fdf1e9; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .92rem; margin: .6rem 0; }
th, td { text-align: left; vertical-align: top; padding: .3rem .9rem .3rem 0; border-bottom: 1px solid #e3e3e3; }
th { font-weight: 600; }
.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
td:first-child { white-space: nowrap; }
td i { display: inline-block; width: .8em; height: .8em; margin-right: .45em; }
figure { margin: 1rem 0; }
figcaption { font-size: .9rem; color: #444; }
img { max-width: 100%; height: auto; display: block; border: 1px solid #ccc; }
svg { width: 100%; height: auto; display: block; font: 13px "DejaVu Sans", Arial, sans-serif; }
svg .title { font-size: 15px; font-weight: 600; }
svg .grid { stroke: #e6e6e6; stroke-width: 1; }
svg .axis { stroke: #555; stroke-width: 1; }
svg .curve { fill: none; stroke-linejoin: round; }
footer { margin-top: 3rem; font-size: .85rem; color: #555; }
@media print { body { max-width: none; } figure, tr { break-inside: avoid; } }
)css";

}  // namespace flownav
