#pragma once
#include <span>
#include <string>
#include <string_view>

/// Writes the frame of a self-contained page. Nothing is fetched, and a policy in the page's head
/// makes the browser enforce that. The style is page.css, the script page.js. The policy names the
/// script by its hash, so that no script within a program text can run.
namespace arbiter::tools {

/// A column of the page's sortable table.
struct Column {
  const char *key; ///< name in the address: "#sort=cycles"
  const char *title;
  bool numeric = false;  ///< sorts from the largest value down
  const char *hint = ""; ///< a sentence about the column; may be empty
};

/// Returns the start of the page.
/// \param title plain text
[[nodiscard]] std::string pageHead(std::string_view title);

/// Returns the filter and the start of the table, up to its first row. A row's first cell links to
/// the row's section. `<tr data-s=STATUS>` offers the row's status in the filter. A cell sorts by
/// its data-v, or else by its text; empty cells come last.
/// The script keeps its state in the page's address, joined by `&`: `#sort=KEY` (`#sort=-KEY`:
/// reversed), `filter=WORDS`, `status=STATUS` and `open=all` (the sections that are shown). Without
/// a script, everything is shown unsorted.
[[nodiscard]] std::string sortableTable(std::span<const Column> columns);
inline constexpr std::string_view kSortableTableEnd = "</tbody></table></div>\n";

/// Returns the script and the page's end.
[[nodiscard]] std::string pageFoot();

} // namespace arbiter::tools
