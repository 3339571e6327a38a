// The figures of the page from its data; what methods they show; where in the page one is.

const axisOfTime = (domain, label) => ({ log: true, domain, text: timeText, label, name: "time" });
const axisOfError = (domain, label) => ({ log: true, domain, text: powerText, label, name: "error" });

const seriesOfWork = (studies) => studies.map(({ c, label, marks, curve }) => ({
  c, label,
  line: curve.map((place) => marks[place]),
  marks: marks.map(([x, y, record, bounded, title]) => ({
    x, y, record, title, hollow: bounded === 1, text: `${timeText(x)}, error of x ${bounded ? "below " : ""}${powerText(y)}`,
  })),
}));

const workDomains = (studies, floor) => {
  const marks = studies.flatMap((study) => study.marks);
  return [domainAround(marks.map((mark) => mark[0]), true, 2),
    domainAround(marks.map((mark) => mark[1]).concat(floor > 0 ? floor : []), true, 3)];
};

const workSpec = (title, studies, floor, width, height) => {
  const [x, y] = workDomains(studies, floor);
  return [{
    width, height, label: title, series: seriesOfWork(studies), rule: floor > 0 ? floor : undefined,
    x: axisOfTime(x, "time, set-up and solve"), y: axisOfError(y, "error of x"),
  }];
};

let common; // axes of all scenes side by side
const smallSpec = (title, data, scene, width) => {
  common ??= workDomains(Object.values(data.scenes).flatMap(({ work }) => work?.own ?? []), 0);
  return [{
    width, height: 190, small: true, label: title, series: seriesOfWork(data.scenes[scene].work?.own ?? []),
    x: axisOfTime(common[0]), y: axisOfError(common[1]),
  }];
};

const zip = (a, b) => a.map((value, i) => [value, b[i]]);

const motionSeries = ({ orbit, answers }, abscissa, ordinate) => [
  { label: "certified orbit", broad: true, line: zip(orbit[abscissa], orbit[ordinate]) },
  ...answers.map((answer) => ({
    c: answer.c, label: answer.label, record: answer.record, line: zip(answer[abscissa], answer[ordinate]),
  })),
];

const kSignals = [["x", "x [m]"], ["v", "velocity [m/s]"], ["f", "force [N]"], ["p", "impulse [N s]"]];
const axisOfSignal = (series, at, name, label) => ({
  domain: domainAround(series.flatMap(({ line }) => line.map((point) => point[at])), false, 0.05),
  text: numberText, label, name: `${name} =`,
});

const waveformSpecs = (title, motion, width) => kSignals.map(([key, label], i) => {
  const series = motionSeries(motion, "t", key);
  const last = i === kSignals.length - 1;
  return {
    width, height: last ? 150 : 116, label: `${title}: ${label}`, series, fixed: true, bare: !last,
    x: { domain: d3.extent(motion.orbit.t), text: numberText, label: last ? "t [s]" : undefined, name: "t =" },
    y: axisOfSignal(series, 1, key, label),
  };
});

const portraitSpec = (title, motion, width) => {
  const series = motionSeries(motion, "x", "v");
  return [{
    width, height: Math.min(width, 440), label: title, series,
    x: axisOfSignal(series, 0, "x", "x [m]"), y: axisOfSignal(series, 1, "v", "velocity [m/s]"),
  }];
};

const profileSpecs = (title, panels, width) => {
  const largest = d3.max(panels.flatMap(({ curves }) => curves.flatMap(({ steps }) => steps.map((step) => step[0])))) ?? 1;
  const end = Math.max(10, 1.5 * largest);
  const across = width < 640 ? 1 : panels.length;
  return panels.map(({ error, curves }, i) => ({
    width: Math.floor(width / across), height: 260, fixed: true, label: `${title}, error ${powerText(error)}`,
    title: `error ${powerText(error)}`,
    x: { log: true, domain: [1, end], text: powerText, label: "time / fastest", name: "time / fastest =" },
    y: { domain: [0, 1.02], text: d3.format(".0%"), label: i % across === 0 ? "share of scenes solved" : undefined, name: "solved" },
    series: curves.map(({ c, label, steps }) => ({ c, label, step: true, line: [...steps, [end, steps.at(-1)[1]]] })),
  }));
};

const specsOf = (figure, data, width) => {
  const { kind, of, title } = figure.dataset;
  const scene = data.scenes?.[of];
  switch (kind) {
    case "small": return smallSpec(title, data, of, width);
    case "work": return workSpec(title, scene.work.own, scene.work.floor, width, 340);
    case "other": return workSpec(title, scene.work.other, 0, width, 340);
    case "waveforms": return waveformSpecs(title, scene.motion, width);
    case "portrait": return portraitSpec(title, scene.motion, width);
    default: return profileSpecs(title, data.profiles[of], width);
  }
};

// A drawing of the program, in the colours of the page.
const schematicOf = (figure, text) => {
  const drawing = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
  for (const part of drawing.querySelectorAll("style, title, .sheet")) part.remove();
  drawing.setAttribute("aria-label", figure.dataset.title);
  return document.importNode(drawing, true);
};

const draw = (figure, data) => {
  const width = Math.floor(figure.clientWidth);
  if (width < 120 || Number(figure.dataset.drawn) === width) return;
  figure.querySelector(".panels")?.remove();
  const panels = document.createElement("div");
  panels.className = "panels";
  figure.prepend(panels);
  if (figure.dataset.kind === "schematic") panels.append(schematicOf(figure, data.scenes[figure.dataset.of].schematic));
  else new Chart(panels, specsOf(figure, data, width));
  figure.dataset.drawn = width;
};

// Which configurations the figures below a legend show.
const configurationsBelow = (section, data) => {
  const found = new Set();
  for (const { dataset: { kind, of } } of section.querySelectorAll(".chart")) {
    const scene = data.scenes?.[of];
    if (kind === "schematic") continue;
    const lists = kind === "profile" ? data.profiles[of].map((panel) => panel.curves)
      : [kind === "other" ? scene.work?.other : scene.work?.own, kind === "waveforms" ? scene.motion.answers : []];
    for (const { c } of lists.flatMap((list) => list ?? [])) found.add(c);
  }
  return [...found].sort((a, b) => a - b);
};

const showSwitches = () => {
  for (const series of document.querySelectorAll("[data-c]")) series.classList.toggle("off", switchedOff.has(Number(series.dataset.c)));
  for (const key of document.querySelectorAll(".legend [data-key]")) key.setAttribute("aria-pressed", !switchedOff.has(Number(key.dataset.key)));
};

const keyOf = (configuration, name) => {
  const key = document.createElement("button");
  key.type = "button";
  key.dataset.key = configuration;
  const sample = d3.select(key).append("svg").attr("width", 34).attr("height", 14).attr("aria-hidden", "true")
    .append("g").attr("class", classOf(configuration));
  sample.append("path").attr("class", "line").attr("d", "M1,7H33").attr("stroke-dasharray", dashOf(configuration));
  sample.append("g").attr("class", "mark").attr("transform", "translate(17,7)").append("path").attr("d", markPath(configuration));
  key.append(name);
  key.addEventListener("click", () => {
    if (!switchedOff.delete(configuration)) switchedOff.add(configuration);
    showSwitches();
  });
  return key;
};

const fillLegend = (legend, data) => {
  const shown = configurationsBelow(legend.parentElement, data);
  legend.setAttribute("role", "group");
  legend.setAttribute("aria-label", "Methods in the figures");
  const all = Object.assign(document.createElement("button"), { type: "button", textContent: "all" });
  const none = Object.assign(document.createElement("button"), { type: "button", textContent: "none" });
  all.addEventListener("click", () => { switchedOff.clear(); showSwitches(); });
  none.addEventListener("click", () => { for (const c of shown) switchedOff.add(c); showSwitches(); });
  legend.append(...shown.map((c) => keyOf(c, data.configurations[c])));
  if (shown.length > 2) legend.append(all, none);
};

// The link of the section that one reads is marked.
const followReading = () => {
  const links = new Map([...document.querySelectorAll("nav a")].map((link) => [link.hash.slice(1), link]));
  const sections = [...document.querySelectorAll("main section[id]")].filter((section) => links.has(section.id));
  let current;
  const mark = () => {
    const read = sections.findLast((section) => section.getBoundingClientRect().top < 0.3 * innerHeight);
    if (read === current) return;
    links.get(current?.id)?.removeAttribute("aria-current");
    links.get(read?.id)?.setAttribute("aria-current", "location");
    current = read;
  };
  // Each time that one of them passes the line at three tenths of the window.
  const observer = new IntersectionObserver(mark, { rootMargin: "-30% 0px -70% 0px" });
  for (const section of sections) observer.observe(section);
};

const start = async () => {
  const data = await ready;
  for (const legend of document.querySelectorAll(".legend")) fillLegend(legend, data);
  const figures = [...document.querySelectorAll(".chart")];
  // Drawn when they come near the window, and again when their width changes.
  const near = new Set();
  const widths = new ResizeObserver((entries) => { for (const { target } of entries) if (near.has(target)) draw(target, data); });
  const seen = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting || near.has(target)) continue;
      near.add(target);
      draw(target, data);
      widths.observe(target);
    }
  }, { rootMargin: "800px" });
  for (const figure of figures) seen.observe(figure);
  addEventListener("beforeprint", () => { for (const figure of figures) draw(figure, data); });
  showRecord();
  document.documentElement.dataset.ready = "yes";
};

if (matchMedia("(max-width: 56rem)").matches) document.querySelector("nav details").open = false;
followReading();
start();
