// Numbers as text, scales and axes.

const kSuperscripts = "⁰¹²³⁴⁵⁶⁷⁸⁹";
const threeDigits = d3.format(".3~r");

const timeText = (seconds) => {
  for (const [unit, size] of [["s", 1], ["ms", 1e-3], ["µs", 1e-6]]) {
    if (seconds >= 0.9995 * size) return `${threeDigits(seconds / size)} ${unit}`;
  }
  return `${threeDigits(seconds / 1e-9)} ns`;
};

// 0.001 is 10⁻³, 0.002 is 2·10⁻³.
const powerText = (value) => {
  const power = Math.floor(Math.log10(value) + 1e-9);
  const factor = Number(d3.format(".2~r")(value / 10 ** power));
  const digits = [...String(Math.abs(power))].map((digit) => kSuperscripts[digit]).join("");
  const base = power === 0 ? "1" : power === 1 ? "10" : `10${power < 0 ? "⁻" : ""}${digits}`;
  return factor === 1 ? base : power === 0 ? String(factor) : `${factor}·${base}`;
};

const numberText = d3.format(".4~g");

// Powers of ten, so many that there is room for; within less than two decades also twice and five times them.
const logTicks = (scale, most) => {
  const [least, largest] = scale.domain().map(Math.log10);
  const step = Math.max(1, Math.ceil((largest - least) / most));
  const ticks = [];
  for (let power = Math.floor(least); power <= Math.ceil(largest); ++power) {
    if (power % step !== 0) continue;
    for (const factor of largest - least < 2 ? [1, 2, 5] : [1]) ticks.push(factor * 10 ** power);
  }
  const inside = ticks.filter((tick) => tick >= 10 ** least * (1 - 1e-9) && tick <= 10 ** largest * (1 + 1e-9));
  return inside.length > 1 ? inside : scale.ticks(4);
};

// An axis of {log, domain, text}: the scale over `range`, and its ticks for `most` of them.
const scaleOf = (axis, range) => (axis.log ? d3.scaleLog() : d3.scaleLinear()).domain(axis.domain).range(range);
const ticksOf = (axis, scale, most) => (axis.log ? logTicks(scale, most) : scale.ticks(most));

// Around values, with a margin on both sides: a factor of a logarithmic axis, a share of a linear one.
const domainAround = (values, log, margin) => {
  const [least, largest] = d3.extent(values);
  if (log) return [least / margin, largest * margin];
  const room = margin * (largest - least || Math.abs(largest) || 1);
  return [least - room, largest + room];
};
