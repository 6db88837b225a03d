// A table or a text that is wider than the page can be scrolled by keys too.
document.addEventListener("DOMContentLoaded", () => {
  for (const part of document.querySelectorAll("[role=main] table, [role=main] pre"))
    if (part.scrollWidth > part.clientWidth) part.tabIndex = 0;
});
