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
const axisOfSignal = (series, at, name, label, stop) => ({
  domain: domainAround(series.flatMap(({ line }) => line.map((point) => point[at])).concat(stop ?? []), false, 0.05),
  text: numberText, label, name: `${name} =`,
});

const waveformSpecs = (title, motion, width) => kSignals.map(([key, label], i) => {
  const series = motionSeries(motion, "t", key);
  const last = i === kSignals.length - 1;
  return {
    width, height: last ? 150 : 116, label: `${title}: ${label}`, series, fixed: true, bare: !last,
    x: { domain: d3.extent(motion.orbit.t), text: numberText, label: last ? "t [s]" : undefined, name: "t =" },
    y: axisOfSignal(series, 1, key, label, key === "x" ? motion.stop : undefined),
    ...(key === "x" && motion.stop !== undefined ? { rule: motion.stop, stop: true } : {}),
  };
});

const portraitSpec = (title, motion, width) => {
  const series = motionSeries(motion, "x", "v").map((one) => ({ ...one, smooth: true }));
  return [{
    width, height: Math.min(width, 440), label: title, series,
    x: axisOfSignal(series, 0, "x", "x [m]", motion.stop), y: axisOfSignal(series, 1, "v", "velocity [m/s]"), wall: motion.stop,
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

// Special points of a response by their kind.
const kKinds = { "fold": d3.symbolTriangle, "period-doubling": d3.symbolSquare, "neimark-sacker": d3.symbolDiamond, "branch-point": d3.symbolStar,
  "phase-resonance": d3.symbolWye, "grazing": d3.symbolCircle, "contact-change": d3.symbolCross };
const shapeOf = (kind) => d3.symbol().type(kKinds[kind]).size(kMarkArea)();
const kParts = [["stable", 1, {}], ["unstable", 0, { dash: "5 4" }], ["stability unknown", -1, { thin: true }]];

// The pieces of branches that are of one stability, null between them. A piece is what its first point is, or its last
// where a grazing leaves the first without multipliers.
const piecesOf = (branches, stability) => branches.flatMap(({ w, a, s }) => {
  const line = [];
  let drawing = false;
  for (let i = 0; i + 1 < w.length; ++i) {
    const belongs = (s[i] === -1 ? s[i + 1] : s[i]) === stability;
    if (belongs && !drawing) line.push([w[i], a[i]]);
    if (belongs) line.push([w[i + 1], a[i + 1]]);
    if (drawing && !belongs) line.push(null);
    drawing = belongs;
  }
  return [...line, null];
});

const specialMarks = ({ points, record }, of) => points.map(([kind, x, y, order, there]) => ({
  x, y, record, hollow: there === 0, shape: shapeOf(kind), title: `${of}, ${kind}`,
  text: `${numberText(x)} rad/s, amplitude ${numberText(y)} m${order > 1 ? `, of ${order} forcing periods` : ""}${there === 0 ? ", not on the exact response" : ""}`,
}));

const lineSeries = (curve, label, how) => {
  const parts = kParts.map(([note, stability, style]) => ({
    ...how, ...style, label, record: curve.record, note: `, ${note}`, line: piecesOf(curve.branches, stability),
  })).filter(({ line }) => line.some((point) => point !== null));
  if (parts.length > 0) Object.assign(parts.at(-1), { marks: specialMarks(curve, label), every: true });
  return parts;
};

const dotSeries = (curve) => [{
  c: curve.c, label: curve.label, record: curve.record, dots: true,
  line: curve.branches.flatMap(({ w, a }) => zip(w, a)),
}];

const responseSpec = (title, { from, to, exact, methods }, width) => {
  const amplitudes = [exact, ...methods].flatMap(({ branches }) => branches.flatMap(({ a }) => a)).filter((a) => a > 0);
  return [{
    width, height: Math.max(300, Math.min(460, 0.75 * width)), label: title,
    x: { domain: [from, to], text: numberText, label: "frequency of the load [rad/s]", name: "" },
    y: { log: true, domain: domainAround(amplitudes, true, 1.3), text: numberText, label: "amplitude [m]", name: "amplitude" },
    series: [
      ...lineSeries(exact, "exact", { broad: true }),
      ...methods.flatMap((method) => (method.steps ? dotSeries(method) : lineSeries(method, method.label, { c: method.c, dash: "" }))),
    ],
  }];
};

// What the marks of a response are.
const kindsKey = ({ exact, methods }) => {
  const key = document.createElement("div");
  key.className = "kinds";
  const found = new Set([exact, ...methods].flatMap(({ points }) => points.map(([kind]) => kind)));
  for (const kind of Object.keys(kKinds).filter((one) => found.has(one))) {
    const entry = document.createElement("span");
    d3.select(entry).append("svg").attr("width", 14).attr("height", 14).attr("aria-hidden", "true").append("g").attr("class", "mark")
      .attr("transform", "translate(7,7)").append("path").attr("d", shapeOf(kind));
    entry.append(kind);
    key.append(entry);
  }
  return key;
};

const specsOf = (figure, data, width) => {
  const { kind, of, title } = figure.dataset;
  const scene = data.scenes?.[of];
  switch (kind) {
    case "small": return smallSpec(title, data, of, width);
    case "work": return workSpec(title, scene.work.own, scene.work.floor, width, 340);
    case "other": return workSpec(title, scene.work.other, 0, width, 340);
    case "waveforms": return waveformSpecs(title, scene.motion, width);
    case "response": return responseSpec(title, scene.response, width);
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
  if (figure.dataset.kind === "response") panels.append(kindsKey(data.scenes[figure.dataset.of].response));
  figure.dataset.drawn = width;
};

// Which configurations the figures below a legend show, each with its name; of responses the name tells the law where
// that is not the scene's.
const configurationsBelow = (section, data) => {
  const found = new Map();
  for (const { dataset: { kind, of } } of section.querySelectorAll(".chart")) {
    const scene = data.scenes?.[of];
    if (kind === "schematic") continue;
    const lists = kind === "response" ? [scene.response.methods]
      : kind === "profile" ? data.profiles[of].map((panel) => panel.curves)
      : [kind === "other" ? scene.work?.other : scene.work?.own, kind === "waveforms" ? scene.motion.answers : []];
    for (const { c, label } of lists.flatMap((list) => list ?? [])) found.set(c, kind === "response" ? label : data.configurations[c]);
  }
  return [...found].sort(([a], [b]) => a - b);
};

const showSwitches = () => {
  for (const series of document.querySelectorAll("[data-c]")) series.classList.toggle("off", switchedOff.has(Number(series.dataset.c)));
  for (const key of document.querySelectorAll(".legend [data-key]")) key.setAttribute("aria-pressed", !switchedOff.has(Number(key.dataset.key)));
};

// The sample shows what the figures draw: of responses a line or, of methods by steps, a dot.
const addSample = (sample, configuration, steps) => {
  if (steps !== true) sample.append("path").attr("class", "line").attr("d", "M1,7H33").attr("stroke-dasharray", steps === undefined ? dashOf(configuration) : null);
  if (steps === true) sample.append("path").attr("class", "line dots").attr("d", [6, 17, 28].map((x) => dotPath(x, 7)).join(""));
  if (steps === undefined) sample.append("g").attr("class", "mark").attr("transform", "translate(17,7)").append("path").attr("d", markPath(configuration));
};

const keyOf = (configuration, name, steps) => {
  const key = document.createElement("button");
  key.type = "button";
  key.dataset.key = configuration;
  const sample = d3.select(key).append("svg").attr("width", 34).attr("height", 14).attr("aria-hidden", "true")
    .append("g").attr("class", classOf(configuration));
  addSample(sample, configuration, steps);
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
  none.addEventListener("click", () => { for (const [c] of shown) switchedOff.add(c); showSwitches(); });
  legend.append(...shown.map(([c, name]) => keyOf(c, name, data.steps?.[c] ?? undefined)));
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
