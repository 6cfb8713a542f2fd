#pragma once

namespace stepwire {

/// Style sheet of the gallery page: system fonts, light and dark, as many columns as fit.
inline constexpr const char* gallery_style = R"css(
:root {
  --page: #f6f7f8; --card: #ffffff; --text: #1c2227; --soft: #56616b; --line: #dde2e6; --link: #0b61a4;
  --good: #1a7a3c; --known: #8a5a00; --bad: #b3261e;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #14181b; --card: #1e2327; --text: #e6eaed; --soft: #a3afb8; --line: #343c42; --link: #7cc0f5;
    --good: #6fd08c; --known: #e8b75a; --bad: #ff8a80;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0; background: var(--page); color: var(--text);
  font: 16px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif;
}
header, main { max-width: 1500px; margin: 0 auto; padding: 1.5rem; }
header { padding-bottom: 0; }
header > p:not(.summary) { max-width: 48rem; color: var(--soft); }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .5rem; }
h2 { font-size: 1.15rem; line-height: 1.35; margin: 0 0 .75rem; }
h2 .label { color: var(--soft); font-weight: 500; margin-right: .35rem; }
h3 { font-size: .8rem; text-transform: uppercase; letter-spacing: .06em; color: var(--soft); margin: 1rem 0 .25rem; }
a { color: var(--link); }
main { display: grid; gap: 1.5rem; grid-template-columns: repeat(auto-fill, minmax(min(30rem, 100%), 1fr)); align-items: start; }
article { background: var(--card); border: 1px solid var(--line); border-radius: 10px; padding: 1.25rem; min-width: 0; }
article:target { outline: 3px solid var(--link); }
img { display: block; width: 100%; height: auto; background: #fff; border-radius: 6px; margin-bottom: .75rem; }
section { margin: 1.5rem 0 0; }
section h2 { margin-bottom: .25rem; }
section li em { display: inline-block; margin-top: .15rem; }
.index { list-style: none; margin: 0; padding: 0; columns: 22rem; column-gap: 2rem; }
.index li { padding: .2rem 0; break-inside: avoid; }
.index .name { font-weight: 600; margin-right: .25rem; }
.index .verdict { font-weight: 500; font-size: .85em; white-space: nowrap; margin-left: .25rem; }
.disagrees { margin: .25rem 0; padding-left: 1.1rem; max-width: 70rem; }
.disagrees li { padding: .25rem 0; }
section details { margin-top: .25rem; overflow-x: auto; }
.summary { display: inline-block; font-weight: 600; border-left: 4px solid; padding: .35rem .9rem; background: var(--card); margin: .5rem 0; }
.summary.good, .good .verdict { color: var(--good); }
.summary.bad, .bad .verdict { color: var(--bad); }
.known .verdict { color: var(--known); }
.claims { list-style: none; margin: 0; padding: 0; }
.claims li { padding: .5rem 0; border-top: 1px solid var(--line); overflow-wrap: anywhere; }
.verdict { font-weight: 600; margin-right: .35rem; }
.good .verdict::before { content: "✓ "; }
.bad .verdict::before { content: "✗ "; }
.known .verdict::before { content: "≠ "; }
code { font: .85em ui-monospace, "SF Mono", Menlo, Consolas, "DejaVu Sans Mono", monospace; color: var(--soft); }
.value { font-weight: 600; white-space: nowrap; }
.value::before { content: "→ "; color: var(--soft); font-weight: 400; }
em { color: var(--soft); font-size: .92em; }
details { margin-top: 1rem; }
summary { cursor: pointer; color: var(--soft); }
table { border-collapse: collapse; width: 100%; font-size: .9em; margin-top: .5rem; }
th, td { text-align: left; padding: .3rem .6rem .3rem 0; border-top: 1px solid var(--line); vertical-align: top; }
.error { white-space: pre-wrap; overflow-wrap: anywhere; color: var(--bad); font-size: .85em; }
.links { margin: 1rem 0 0; font-size: .92em; }
@media print { body { background: #fff; } article { break-inside: avoid; } }
)css";

}  // namespace stepwire
