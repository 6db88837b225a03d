#pragma once
#include <span>
#include <string>
#include <string_view>

/// The frame of a page that stands alone: nothing is fetched, and a policy in its head has the
/// browser hold it to that. The style and the script are page.css and page.js; the policy names the
/// script by its hash, so that no other script runs, whatever a program text may hold.
namespace arbiter::tools {

/// A column of the page's one table that sorts.
struct Column {
  const char *key; ///< in an address: "#sort=cycles"
  const char *title;
  bool numeric = false;  ///< sorts from the largest down
  const char *hint = ""; ///< a sentence about it; may be empty
};

/// \param title plain text
[[nodiscard]] std::string pageHead(std::string_view title);

/// The filter, then the table's beginning, up to its first row. A row begins with a cell that links
/// to its section; `<tr data-s=STATUS>` makes its status one that the filter offers. A cell sorts
/// by its data-v where it has one, else by its text; an empty one comes last. The script reads
/// `#sort=KEY` (`#sort=-KEY`: the other way), `filter=WORDS`, `status=STATUS` and `open=all` (the
/// sections that are shown), joined by `&`, in the page's address, and keeps them there. Without a
/// script everything is there, unsorted.
[[nodiscard]] std::string sortableTable(std::span<const Column> columns);
inline constexpr std::string_view kSortableTableEnd = "</tbody></table></div>\n";

/// The script and the page's end.
[[nodiscard]] std::string pageFoot();

} // namespace arbiter::tools
