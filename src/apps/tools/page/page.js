"use strict";
// Sorts and filters the table of programs, and opens the sections that links lead to. The page's
// address holds the state: #sort=-cycles&filter=water&status=invalid&open=all.
(() => {
  const table = document.getElementById("programs");
  const body = table.tBodies[0];
  const heads = Array.from(table.tHead.rows[0].cells);
  const form = document.getElementById("find");
  const shown = form.querySelector("output");
  const collator = new Intl.Collator("en", {numeric: true});
  let sort = "", open = "";

  const programs = Array.from(body.rows, row => {
    const link = row.querySelector("a[href^='#']");
    const words = Array.from(row.cells).filter(cell => !cell.classList.contains("n"));
    return {
      row,
      section: link && document.getElementById(decodeURIComponent(link.hash.slice(1))),
      words: words.map(cell => cell.textContent).join(" ").toLowerCase(),
      status: row.dataset.s || "",
    };
  });

  for (const status of new Set(programs.map(program => program.status)))
    if (status)
      form.elements.status.add(new Option(status, status));

  function applySort() {
    const key = sort.replace(/^-/, "");
    const column = heads.findIndex(head => head.dataset.k === key);
    const numeric = column >= 0 && heads[column].classList.contains("n");
    const descending = numeric !== sort.startsWith("-");
    for (const head of heads)
      head.ariaSort = null;
    let order = programs;
    if (column >= 0) {
      heads[column].ariaSort = descending ? "descending" : "ascending";
      const sign = descending ? -1 : 1;
      const keyed = programs.map(program => {
        const cell = program.row.cells[column];
        return {program, value: cell.dataset.v ?? cell.textContent};
      });
      keyed.sort((a, b) => {
        if (a.value === "" || b.value === "")
          return (a.value === "") - (b.value === "");
        return sign * (numeric ? a.value - b.value : collator.compare(a.value, b.value));
      });
      order = keyed.map(pair => pair.program);
    }
    body.append(...order.map(program => program.row));
  }

  function applyFilter() {
    const words = form.elements.filter.value.toLowerCase().split(/\s+/);
    const status = form.elements.status.value;
    let count = 0;
    for (const program of programs) {
      const match = (!status || program.status === status) &&
                    words.every(word => program.words.includes(word));
      program.row.hidden = !match;
      if (program.section)
        program.section.hidden = !match;
      count += match;
    }
    shown.textContent = count === programs.length ? "" : `${count} of ${programs.length} shown`;
  }

  function applyOpen() {
    for (const program of programs)
      if (program.section && !program.section.hidden)
        program.section.open = open === "all";
  }

  function remember() {
    const state = new URLSearchParams();
    if (sort)
      state.set("sort", sort);
    for (const name of ["filter", "status"])
      if (form.elements[name].value)
        state.set(name, form.elements[name].value);
    if (open)
      state.set("open", open);
    history.replaceState(null, "", "#" + state);
  }

  /** Follows the address. A hash with "=" is a state of the table; any other is the id to show. */
  function followAddress() {
    const hash = decodeURIComponent(location.hash.slice(1));
    if (location.hash.includes("=")) {
      const state = new URLSearchParams(location.hash.slice(1));
      sort = state.get("sort") ?? "";
      form.elements.filter.value = state.get("filter") ?? "";
      form.elements.status.value = state.get("status") ?? "";
      open = state.get("open") ?? "";
      applySort();
      applyFilter();
      if (open)
        applyOpen();
      return;
    }
    const target = hash && document.getElementById(hash);
    if (!target)
      return;
    for (let element = target; element; element = element.parentElement) {
      element.hidden = false;
      if (element.tagName === "DETAILS")
        element.open = true;
    }
    target.scrollIntoView();
  }

  table.tHead.addEventListener("click", event => {
    const head = event.target.closest("th");
    if (!head)
      return;
    sort = sort === head.dataset.k ? "-" + sort : head.dataset.k;
    applySort();
    remember();
  });
  form.addEventListener("input", () => {
    applyFilter();
    remember();
  });
  form.addEventListener("submit", event => event.preventDefault());
  for (const button of document.querySelectorAll("button[data-open]"))
    button.addEventListener("click", () => {
      open = button.dataset.open;
      applyOpen();
      remember();
    });
  window.addEventListener("hashchange", followAddress);
  for (const element of document.querySelectorAll("[data-script]"))
    element.hidden = false;
  form.hidden = false;
  followAddress();
})();
