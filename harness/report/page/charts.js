// A chart: one or more panels with the same zoom, of series with lines and marks. What leads to a record is a link.

const kDashes = ["", "6 3", "1.5 2.5", "8 3 1.5 3", "1.5 2.5 1.5 2.5 7 3"];
const kMarks = [d3.symbolSquare, d3.symbolCircle, d3.symbolTriangle, d3.symbolDiamond, d3.symbolWye, d3.symbolStar];
const kMarkArea = 52;       // of a mark [square pixels]
const kReach = 28;          // how far from a mark or a line a pointer still means it [pixels]
const switchedOff = new Set(); // configurations

const classOf = (configuration) => `series c${configuration % 7}`;
const dashOf = (configuration) => kDashes[configuration % kDashes.length];
const markPath = (configuration) => d3.symbol().type(kMarks[configuration % kMarks.length]).size(kMarkArea)();
const kDotRadius = 2.2;     // [pixels]
const dotPath = (x, y) => `M${x - kDotRadius},${y}a${kDotRadius},${kDotRadius} 0 1 0 ${2 * kDotRadius},0a${kDotRadius},${kDotRadius} 0 1 0 ${-2 * kDotRadius},0`;

const hint = document.getElementById("hint");
const hideHint = () => { hint.hidden = true; };
const showHint = (x, y, title, text) => {
  hint.replaceChildren(Object.assign(document.createElement("strong"), { textContent: title }), text);
  hint.hidden = false;
  const box = hint.getBoundingClientRect();
  hint.style.left = `${Math.max(4, Math.min(x + 14, innerWidth - box.width - 8))}px`;
  hint.style.top = `${y + 18 + box.height > innerHeight ? y - box.height - 12 : y + 18}px`;
};

// A portrait as pieces: curves, and impacts as straight lines between them (drawn_waveform.cpp draws likewise).
const piecesOfPortrait = (line) => {
  const [x, v] = [0, 1].map((at) => { const [least, largest] = d3.extent(line, (point) => point[at]); return largest - least || 1; });
  const pieces = [[line[0]]];
  for (let i = 1; i < line.length; ++i) {
    const [dx, dv] = [Math.abs(line[i][0] - line[i - 1][0]) / x, Math.abs(line[i][1] - line[i - 1][1]) / v];
    if (dx < 0.01 && dv > 0.25) pieces.push([line[i - 1], line[i]], [line[i]]);
    else pieces.at(-1).push(line[i]);
  }
  return pieces.filter((piece) => piece.length > 1);
};

let clips = 0;

class Panel {
  // spec: {width, height, x, y: axes {log, domain, text, label}, title, label, rule, wall, series: [{c, label, record,
  // line, step, smooth, broad, dash, thin, dots, note, marks: [{x, y, text, record, hollow, title, shape}]}]}; a null in a line
  // is a gap in it; `rule` and `wall` are lines across the panel at a height and upright, `note` is said of points.
  constructor(host, spec, chart) {
    this.spec = spec;
    this.chart = chart;
    const margin = { top: spec.title ? 22 : 8, right: 12, bottom: spec.bare ? 6 : spec.x.label === undefined ? 20 : 40, left: spec.small ? 46 : 64 };
    this.edges = { left: margin.left, right: spec.width - margin.right, top: margin.top, bottom: spec.height - margin.bottom };
    this.x = scaleOf(spec.x, [this.edges.left, this.edges.right]);
    this.y = scaleOf(spec.y, [this.edges.bottom, this.edges.top]);
    this.svg = d3.select(host).append("svg").attr("width", spec.width).attr("height", spec.height)
      .attr("viewBox", `0 0 ${spec.width} ${spec.height}`).attr("role", "group").attr("tabindex", 0)
      .attr("aria-label", spec.label);
    this.frame();
    this.addSeries();
    this.listen();
  }

  frame() {
    const { left, right, top, bottom } = this.edges;
    const clip = `clip-${++clips}`;
    this.svg.append("clipPath").attr("id", clip).append("rect").attr("x", left - 6).attr("y", top - 6)
      .attr("width", right - left + 12).attr("height", bottom - top + 12);
    const axes = this.svg.append("g").attr("aria-hidden", "true");
    this.bottom = axes.append("g").attr("class", "axis").attr("transform", `translate(0,${bottom})`);
    this.left = axes.append("g").attr("class", "axis").attr("transform", `translate(${left},0)`);
    const words = (text, x, y) => axes.append("text").attr("class", "label").attr("x", x).attr("y", y)
      .attr("text-anchor", "middle").text(text);
    const middle = (top + bottom) / 2;
    if (this.spec.title) words(this.spec.title, (left + right) / 2, top - 8);
    if (this.spec.x.label) words(this.spec.x.label, (left + right) / 2, bottom + 35);
    if (this.spec.y.label) words(this.spec.y.label, 12, middle).attr("transform", `rotate(-90,12,${middle})`);
    this.body = this.svg.append("g").attr("clip-path", `url(#${clip})`);
    if (this.spec.rule !== undefined) {
      this.rule = this.body.append("line").attr("class", this.spec.stop ? "rule stop" : "rule").attr("x1", left).attr("x2", right).attr("aria-hidden", "true");
    }
    if (this.spec.wall !== undefined) {
      this.wall = this.body.append("line").attr("class", "rule stop").attr("y1", top).attr("y2", bottom).attr("aria-hidden", "true");
    }
  }

  addSeries() {
    this.series = this.spec.series.map((series) => {
      const group = this.body.append("g").attr("class", series.c === undefined ? "series orbit" : classOf(series.c))
        .classed("off", switchedOff.has(series.c));
      if (series.c !== undefined) group.attr("data-c", series.c);
      const link = (record, title) => group.append("a").attr("href", `#record-${record + 1}`).attr("tabindex", -1)
        .attr("aria-label", title);
      const path = (series.record === undefined ? group : link(series.record, series.label))
        .append("path").attr("class", ["line", series.broad && "broad", series.thin && "thin", series.dots && "dots"].filter(Boolean).join(" "));
      const dash = series.dash ?? (series.c === undefined ? "" : dashOf(series.c));
      if (dash) path.attr("stroke-dasharray", dash);
      const marks = (series.marks ?? []).map((mark) => {
        const anchor = link(mark.record, `${mark.title}: ${mark.text}`).attr("class", "mark").classed("hollow", mark.hollow);
        anchor.append("circle").attr("class", "reach").attr("r", 9);
        anchor.append("path").attr("d", mark.shape ?? markPath(series.c));
        return { ...mark, anchor };
      });
      return { ...series, group, path, marks };
    });
  }

  // Everything at its place under the chart's zoom; `fixed` panels keep their vertical axis.
  render() {
    const transform = this.chart.transform;
    const width = this.edges.right - this.edges.left;
    const height = this.edges.bottom - this.edges.top;
    const x = transform.rescaleX(this.x);
    const y = this.spec.fixed ? this.y : transform.rescaleY(this.y);
    this.now = { x, y };
    const axis = (kind, spec, scale, length, most) => kind(scale).tickValues(ticksOf(spec, scale, most))
      .tickFormat(spec.text).tickSizeInner(-length).tickSizeOuter(0).tickPadding(6);
    this.bottom.call(axis(d3.axisBottom, this.spec.x, x, height, Math.max(2, Math.floor(width / 65))));
    if (this.spec.bare) this.bottom.selectAll("text").remove();
    this.left.call(axis(d3.axisLeft, this.spec.y, y, width, Math.max(2, Math.floor(height / 32))));
    if (this.rule) this.rule.attr("y1", y(this.spec.rule)).attr("y2", y(this.spec.rule));
    if (this.wall) this.wall.attr("x1", x(this.spec.wall)).attr("x2", x(this.spec.wall));
    const line = d3.line().defined((point) => point !== null).x((point) => x(point[0])).y((point) => y(point[1]));
    for (const series of this.series) {
      series.path.attr("d", series.dots ? series.line.map((point) => dotPath(x(point[0]), y(point[1]))).join("")
        : series.smooth ? piecesOfPortrait(series.line).map((piece) => line.curve(piece.length > 2 ? d3.curveCatmullRom : d3.curveLinear)(piece)).join("")
        : line.curve(series.step ? d3.curveStepAfter : d3.curveLinear)(series.line));
      for (const mark of series.marks) mark.anchor.attr("transform", `translate(${x(mark.x)},${y(mark.y)})`);
    }
  }

  listen() {
    const frame = [[this.edges.left, this.edges.top], [this.edges.right, this.edges.bottom]];
    const zoom = d3.zoom().scaleExtent([1, 1000]).clickDistance(4).extent(frame).translateExtent(frame)
      // A wheel scrolls the page and a finger moves it, unless with Ctrl or a second one.
      .filter(() => (d3.event.type === "wheel" ? d3.event.ctrlKey || d3.event.metaKey
        : d3.event.type === "touchstart" ? d3.event.touches.length > 1 : !d3.event.button))
      .on("zoom", () => this.chart.zoomTo(d3.event.transform, this));
    this.zoom = zoom;
    this.svg.call(zoom).style("touch-action", "pan-x pan-y");
    const node = this.svg.node();
    node.addEventListener("pointermove", (event) => this.point(event));
    node.addEventListener("pointerleave", hideHint);
    node.addEventListener("keydown", (event) => this.press(event));
    node.addEventListener("focusin", (event) => this.describe(event.target.closest("a")));
    node.addEventListener("focusout", hideHint);
    // Near a mark is on it.
    node.addEventListener("click", (event) => {
      const near = event.target.closest("a") === null ? this.nearest(event) : undefined;
      if (near?.record !== undefined) location.hash = `#record-${near.record + 1}`;
    });
  }

  shown() { return this.series.filter((series) => series.c === undefined || !switchedOff.has(series.c)); }

  // The mark, or else the point of a line, that a pointer means.
  nearest(event) {
    const hit = event.target.closest(".mark");
    if (hit !== null) return this.series.flatMap((series) => series.marks).find((mark) => mark.anchor.node() === hit);
    const box = this.svg.node().getBoundingClientRect();
    const px = event.clientX - box.left;
    const py = event.clientY - box.top;
    let best, least = kReach;
    const ask = (x, y, answer) => {
      const distance = Math.hypot(this.now.x(x) - px, this.now.y(y) - py);
      if (distance < least) [least, best] = [distance, answer];
    };
    for (const series of this.shown()) {
      for (const mark of series.marks) ask(mark.x, mark.y, mark);
      if (series.marks.length > 0 && !series.every) continue;
      for (const point of series.line) {
        if (point === null) continue;
        const [x, y] = point;
        const text = `${this.spec.x.name} ${this.spec.x.text(x)}, ${this.spec.y.name} ${this.spec.y.text(y)}${series.note ?? ""}`;
        ask(x, y, { x, y, title: series.label, text, record: series.record });
      }
    }
    return best;
  }

  point(event) {
    const near = this.nearest(event);
    this.svg.style("cursor", near?.record === undefined ? null : "pointer");
    if (near === undefined) hideHint();
    else showHint(event.clientX, event.clientY, near.title, near.text);
  }

  links() { return [...this.svg.node().querySelectorAll(".series:not(.off) a")]; }

  // The hint of a link that has the focus.
  describe(anchor) {
    if (anchor === null) return;
    const box = anchor.getBoundingClientRect();
    const [title, text] = anchor.getAttribute("aria-label").split(/: (?!.*: )/);
    showHint(box.left + box.width / 2, box.top + box.height / 2, title, text ?? "");
  }

  press(event) {
    const links = this.links();
    const here = links.indexOf(document.activeElement);
    const go = { ArrowRight: here + 1, ArrowDown: here + 1, ArrowLeft: here - 1, ArrowUp: here - 1, Home: 0, End: links.length - 1 }[event.key];
    if (go !== undefined) links[(go + links.length) % links.length]?.focus();
    else if (event.key === "Escape") this.svg.node().focus();
    else if (event.key === "+") this.chart.scaleBy(1.6);
    else if (event.key === "-") this.chart.scaleBy(1 / 1.6);
    else if (event.key === "0") this.chart.reset();
    else return;
    event.preventDefault();
  }
}

class Chart {
  constructor(host, specs) {
    this.transform = d3.zoomIdentity;
    this.panels = specs.map((spec) => new Panel(host, spec, this));
    this.tools = document.createElement("div");
    this.tools.className = "zoom";
    const button = (sign, words, act) => {
      const made = Object.assign(document.createElement("button"), { type: "button", textContent: sign });
      made.setAttribute("aria-label", `${words}: ${specs[0].label}`);
      made.addEventListener("click", act);
      this.tools.append(made);
      return made;
    };
    if (!specs[0].small) {
      button("+", "Zoom in", () => this.scaleBy(1.6));
      button("−", "Zoom out", () => this.scaleBy(1 / 1.6));
      this.whole = button("whole", "Show the whole of", () => this.reset());
      host.append(this.tools);
    }
    this.render();
  }

  zoomTo(transform, from) {
    this.transform = transform;
    // The others begin their next gesture from here.
    for (const panel of this.panels) if (panel !== from) panel.svg.node().__zoom = transform;
    hideHint();
    this.render();
  }

  scaleBy(factor) { this.panels[0].svg.call(this.panels[0].zoom.scaleBy, factor); }
  reset() { this.panels[0].svg.call(this.panels[0].zoom.transform, d3.zoomIdentity); }

  render() {
    if (this.whole) this.whole.disabled = this.transform.k === 1;
    for (const panel of this.panels) panel.render();
  }
}
