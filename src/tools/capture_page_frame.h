#pragma once

/// The fixed parts of a capture's page. The script only sorts: without it everything is there.
namespace arbiter::tools {

inline constexpr const char *kCapturePageHead = R"html(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Captured programs</title>
<style>
body { font: 15px/1.45 sans-serif; max-width: 72em; margin: 1.5em auto; padding: 0 1em;
       color: #222; background: #fff; }
table { border-collapse: collapse; margin: .8em 0; }
th, td { padding: .2em .6em; border-bottom: 1px solid #ddd; text-align: left; }
td.n { text-align: right; font-variant-numeric: tabular-nums; }
#programs th { cursor: pointer; position: sticky; top: 0; background: #fff; }
#programs th::after { content: "\2195"; color: #aaa; padding-left: .3em; }
pre { background: #f6f6f4; padding: .6em; overflow-x: auto; }
pre i, td i { color: #a60; font-style: normal; }
.line::before { content: attr(data-n); display: inline-block; width: 3em; padding-right: 1em;
                color: #999; text-align: right; user-select: none; }
.caret, .bad { color: #b00; }
h2 { margin-top: 2em; font-size: 1.1em; border-top: 2px solid #222; padding-top: .4em; }
</style></head><body>
)html";

inline constexpr const char *kCapturePageColumns =
    "<table id=programs><thead><tr><th>program<th>target<th>loads<th>contexts<th>processes"
    "<th>frames<th>draws<th>instructions<th>ALU<th>TEX<th>indirections<th>verdict</tr></"
    "thead><tbody>\n";

inline constexpr const char *kCapturePageFoot = R"html(<script>
"use strict";
const table = document.getElementById("programs"), body = table.tBodies[0];
let last = -1, order = 1;
table.tHead.addEventListener("click", event => {
  const column = event.target.cellIndex;
  if (column === undefined) return;
  order = column === last ? -order : 1;
  last = column;
  const key = row => row.cells[column].textContent;
  const rows = Array.from(body.rows);
  const numbers = rows.length > 0 && rows[0].cells[column].className === "n";
  rows.sort((a, b) => order * (numbers ? Number(key(b)) - Number(key(a))
                                       : key(a).localeCompare(key(b))));
  body.append(...rows);
});
</script></body></html>
)html";

} // namespace arbiter::tools
