"use strict";
// Sorts, filters and searches the overview; without it the page is whole all the same.
(() => {
  const table = document.getElementById("overview");
  const [body, head] = [table.tBodies[0], table.tHead.rows[0]];
  const rows = Array.from(body.rows);
  const [finder, search, state, found] = ["finder", "search", "state", "found"].map((id) => document.getElementById(id));
  const value = (row, column) => row.cells[column].dataset.v ?? "";
  const compare = (a, b) => {
    if (a === "" || b === "") return (a === "" ? 1 : 0) - (b === "" ? 1 : 0);
    const [x, y] = [Number(a), Number(b)];
    return Number.isNaN(x) || Number.isNaN(y) ? a.localeCompare(b) : x - y;
  };
  Array.from(head.cells).forEach((cell, column) => {
    if (column === 0) return;
    const button = document.createElement("button");
    button.type = "button";
    button.append(...cell.childNodes);
    cell.append(button);
    button.addEventListener("click", () => {
      const falling = cell.getAttribute("aria-sort") === "ascending";
      Array.from(head.cells).forEach((other) => other.removeAttribute("aria-sort"));
      cell.setAttribute("aria-sort", falling ? "descending" : "ascending");
      const sign = falling ? -1 : 1;
      const sorted = rows.slice().sort((a, b) => {
        const [x, y] = [value(a, column), value(b, column)];
        // What is missing stays last either way.
        return x === "" || y === "" ? compare(x, y) : sign * compare(x, y);
      });
      body.append(...sorted);
    });
  });
  const show = () => {
    const wanted = search.value.trim().toLowerCase();
    const shown = rows.filter((row) => {
      const fits = row.textContent.toLowerCase().includes(wanted) ? state.value === "" || row.dataset.state === state.value : false;
      row.hidden = !fits;
      return fits;
    });
    found.textContent = shown.length === rows.length ? "" : `${shown.length} of ${rows.length}`;
  };
  search.addEventListener("input", show);
  state.addEventListener("change", show);
  finder.hidden = rows.length === 1;
  // A link to a folded specimen opens it.
  const unfold = () => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (!target) return;
    const folds = [target.closest("details"), target.querySelector(":scope > details")];
    folds.forEach((fold) => { if (fold) fold.open = true; });
    target.scrollIntoView();
  };
  addEventListener("hashchange", unfold);
  if (location.hash) unfold();
})();
