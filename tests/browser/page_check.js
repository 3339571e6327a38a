"use strict";
// What a reader does with the page, and what must then be so.
addEventListener("load", async () => {
  let asked = 0;
  const expect = (ok, what) => {
    ++asked;
    if (!ok) complaints.push(what);
  };

  const images = [...document.querySelectorAll("figure img")];
  await Promise.allSettled(images.map((image) => image.decode()));
  expect(images.length >= 10, `${images.length} figures`);
  for (const image of images) {
    const box = image.getBoundingClientRect();
    expect(image.complete && image.naturalWidth > 100 && box.width > 100 && box.height > 60,
      `figure not visible: ${image.alt}`);
  }

  const table = document.querySelector("#cases table");
  const rows = () => [...table.tBodies[0].rows].filter((row) => !row.hidden);
  const titles = [...table.tHead.rows[0].cells].map((title) => title.textContent);
  const all = rows().length;
  expect(all === document.querySelectorAll("#records details").length, "one row per record");

  const sortBy = (name) => table.tHead.rows[0].cells[titles.indexOf(name)].querySelector("button").click();
  const numbers = (name) => rows().map((row) => row.cells[titles.indexOf(name)].dataset.v)
    .map((value) => (value === undefined ? Infinity : Number(value)));
  const rising = (list) => list.every((value, i) => i === 0 || list[i - 1] <= value);
  const before = numbers("time");
  expect(!rising(before), "a table that is sorted by time before anybody asked");
  sortBy("time");
  expect(rising(numbers("time")), "sorting by time");
  sortBy("time");
  const falling = numbers("time").filter(isFinite);
  expect(rising(falling.toReversed()) && falling[0] > falling.at(-1), "sorting by falling time");
  expect(rows().length === all, "sorting loses no row");

  const tools = document.querySelector("#cases .tools");
  const search = tools.querySelector("input");
  const type = (text) => {
    search.value = text;
    search.dispatchEvent(new Event("input"));
  };
  type("hat-lcp converged");
  expect(rows().length > 0 && rows().length < all, "filter by words");
  expect(rows().every((row) => row.textContent.includes("hat-lcp")), "filter by words shows only those");
  expect(tools.querySelector("output").value === `${rows().length} of ${all} rows`, "count of rows");
  type("");
  expect(rows().length === all, "no words, all rows");
  const scenes = [...tools.querySelectorAll("select")].find((s) => s.options[0].text === "any scene");
  scenes.value = scenes.options[1].value;
  scenes.dispatchEvent(new Event("change"));
  expect(rows().length > 0 && rows().every((row) => row.cells[0].textContent === scenes.value), "filter by scene");

  document.querySelector("#summary a[data-filter]").click();
  expect(rows().length > 0 && rows().length < all, "a method leads to its rows");

  const link = rows()[0].querySelector("a[href^='#record-']");
  location.hash = link.hash;
  await new Promise((resume) => setTimeout(resume, 50));
  const record = document.querySelector(link.hash);
  expect(record.open, "a number opens its record");
  const parsed = JSON.parse(record.querySelector("pre").textContent);
  expect(parsed.case === record.querySelector("summary").textContent, "the record of the case");
  for (const anchor of document.querySelectorAll("a[href^='#']")) {
    expect(document.getElementById(decodeURIComponent(anchor.hash.slice(1))) !== null, `dead link ${anchor.hash}`);
  }

  expect(document.documentElement.scrollWidth <= innerWidth, "the page is wider than its window");
  const luminance = (colour) => {
    const [r, g, b] = colour.match(/[\d.]+/g).map(Number).map((c) => c / 255)
      .map((c) => (c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const style = getComputedStyle(document.body);
  const paper = luminance(style.backgroundColor);
  const dark = matchMedia("(prefers-color-scheme: dark)").matches;
  expect((paper < 0.1) === dark, "paper follows the colour scheme");
  for (const selector of ["body", "figcaption", "td a", "p.note"]) {
    const element = document.querySelector(selector);
    if (element === null) continue;
    const ink = luminance(getComputedStyle(element).color);
    const contrast = (Math.max(ink, paper) + 0.05) / (Math.min(ink, paper) + 0.05);
    expect(contrast >= 4.5, `contrast of ${selector}: ${contrast.toFixed(1)}`);
  }
  expect(performance.getEntriesByType("resource").every((entry) => entry.name.startsWith("data:")),
    "the page asks for something outside itself");

  document.documentElement.dataset.verdict =
    complaints.length === 0 ? `passed ${asked} checks` : complaints.slice(0, 5).join("; ").replaceAll('"', "'");
});
