// The data of the page, and the record behind a link as a dialog.

const ready = (async () => {
  const bytes = Uint8Array.from(atob(document.getElementById("data").textContent), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return JSON.parse(await new Response(stream).text());
})();

const kRecordHash = /^#record-(\d+)$/;
const dialog = document.getElementById("record");

// What a reader asks first of a record, in one line.
const factsOf = (record) => [
  record.status,
  record.response ? "" : record.certificate?.status,
  typeof record.errors?.x_l2 === "number" ? `error of x ${record.errors.x_l2.toExponential(1)}` : "",
  typeof record.seconds?.median === "number" ? timeText(record.seconds.median) : "",
  typeof record.response?.comparison?.["within_0.02"]?.covered === "number"
    ? `${d3.format(".1%")(record.response.comparison["within_0.02"].covered)} of the exact response` : "",
  record.message,
].filter(Boolean).join(" · ");

const showRecord = async () => {
  const found = kRecordHash.exec(location.hash);
  if (found === null) {
    if (dialog.open) dialog.close();
    return;
  }
  const { cases, records } = await ready;
  const place = Number(found[1]) - 1;
  if (records?.[place] === undefined) return;
  dialog.querySelector("h2").textContent = cases[place];
  dialog.querySelector("p").textContent = factsOf(JSON.parse(records[place]));
  dialog.querySelector("pre").textContent = records[place];
  hideHint();
  if (!dialog.open) dialog.showModal();
  dialog.querySelector("pre").scrollTop = 0;
};

dialog.querySelector("button").addEventListener("click", () => dialog.close());
dialog.addEventListener("click", (event) => {
  if (event.target === dialog) dialog.close(); // beside it
});
// The address names no record any more, and the same link opens it again.
dialog.addEventListener("close", () => {
  if (kRecordHash.test(location.hash)) history.replaceState(null, "", location.pathname + location.search);
});
addEventListener("hashchange", showRecord);
