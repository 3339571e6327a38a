"use strict";
// Tables sort by a click on a title and filter by words and by the values of their columns.

const kFilterable = 10;      // rows from which a table gets filters
const kBest = 7;             // methods of a verdict that are shown at first
const kMostChoices = 80;     // values of a column beyond which it gets no list

const words = (row) => row.textContent.toLowerCase();

const valueOf = (row, column) => {
  const cell = row.cells[column];
  if (cell.dataset.v !== undefined) return Number(cell.dataset.v);
  return cell.classList.contains("n") ? Infinity : cell.textContent;
};

// Numbers by value, text by its numbers; what has no number comes last either way.
const compare = (a, b, falling) => {
  if (typeof a === "number" && typeof b === "number") {
    if (a === b) return 0;
    if (!isFinite(a) || !isFinite(b)) return isFinite(a) ? -1 : 1;
    return falling ? b - a : a - b;
  }
  const order = String(a).localeCompare(String(b), "en", { numeric: true });
  return falling ? -order : order;
};

const sortBy = (table, column) => {
  const title = table.tHead.rows[0].cells[column];
  const falling = title.getAttribute("aria-sort") === "ascending";
  for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
  title.setAttribute("aria-sort", falling ? "descending" : "ascending");
  const rows = [...table.tBodies[0].rows];
  rows.sort((a, b) => compare(valueOf(a, column), valueOf(b, column), falling));
  table.tBodies[0].append(...rows);
};

const makeSortable = (table) => {
  [...table.tHead.rows[0].cells].forEach((title, column) => {
    const button = document.createElement("button");
    button.type = "button";
    button.append(...title.childNodes);
    button.addEventListener("click", () => sortBy(table, column));
    title.append(button);
  });
};

const choices = (table, column) => {
  const found = new Set();
  for (const row of table.tBodies[0].rows) found.add(row.cells[column].textContent);
  return [...found].sort((a, b) => a.localeCompare(b, "en", { numeric: true }));
};

const makeFilter = (table) => {
  const tools = document.createElement("div");
  tools.className = "tools";
  const search = document.createElement("input");
  search.type = "search";
  search.placeholder = "words of a row";
  search.setAttribute("aria-label", "show rows with these words");
  const count = document.createElement("output");
  const selects = [];
  const apply = () => {
    const wanted = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    for (const row of table.tBodies[0].rows) {
      const text = words(row);
      row.hidden = !(wanted.every((word) => text.includes(word)) &&
        selects.every((s) => s.value === "" || row.cells[s.dataset.column].textContent === s.value));
      if (!row.hidden) ++shown;
    }
    count.value = `${shown} of ${table.tBodies[0].rows.length} rows`;
  };
  [...table.tHead.rows[0].cells].forEach((title, column) => {
    if (title.classList.contains("n")) return;
    const values = choices(table, column);
    if (values.length < 2 || values.length > kMostChoices) return;
    const select = document.createElement("select");
    select.dataset.column = column;
    select.setAttribute("aria-label", `show only this ${title.textContent}`);
    select.append(new Option(`any ${title.textContent}`, ""), ...values.map((value) => new Option(value, value)));
    select.addEventListener("change", apply);
    selects.push(select);
  });
  search.addEventListener("input", apply);
  tools.append(search, ...selects, count);
  table.parentElement.before(tools);
  table.filterBy = (text) => {
    search.value = "";
    for (const select of selects) {
      select.value = [...select.options].some((option) => option.value === text) ? text : "";
    }
    if (selects.every((select) => select.value === "")) search.value = text.replaceAll(/[[\],]/g, " ");
    apply();
  };
  apply();
};

// The best of a group, and the others when asked for.
const shorten = (table) => {
  const others = [...table.tBodies[0].rows].slice(kBest);
  if (others.length < 2) return;
  const button = document.createElement("button");
  button.type = "button";
  const show = (all) => {
    for (const row of others) row.hidden = !all;
    button.textContent = all ? "the best alone" : `${others.length} more`;
    button.setAttribute("aria-expanded", all);
  };
  button.addEventListener("click", () => show(others[0].hidden));
  table.parentElement.append(button);
  show(false);
};

for (const table of document.querySelectorAll("table")) {
  const isVerdict = table.closest(".verdicts") !== null;
  if (isVerdict) shorten(table);
  else if (table.tBodies[0].rows.length >= kFilterable) makeFilter(table);
  makeSortable(table);
}

// Names of methods and scenes lead to their rows among all cases; a link without a value is such a name itself.
const cases = document.querySelector("#cases table");
for (const link of document.querySelectorAll("a[data-filter]")) {
  link.addEventListener("click", () => cases?.filterBy?.(link.dataset.filter || link.textContent));
}
