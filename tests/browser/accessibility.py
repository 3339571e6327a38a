"""Whether a page can be used by everybody: the rules of WCAG 2.1, level AA, that a program can ask, and those of axe-core."""

from pathlib import Path

# In the page: names, roles, contrast, order of the focus, language, headings, sizes of targets. WCAG 2.1 by its numbers.
ASKED = r"""(() => {
  const found = [];
  const expect = (ok, what) => { if (!ok) found.push(what); };
  const seen = (e) => e.checkVisibility({ visibilityProperty: true }) && e.getBoundingClientRect().width > 0 && !e.closest('.unseen, .skip');
  const words = (e) => `${e.tagName.toLowerCase()}.${e.getAttribute('class') ?? ''} "${e.textContent.trim().slice(0, 40)}"`;
  expect(/^[a-z]{2}/.test(document.documentElement.lang), '3.1.1: no language');
  expect(document.title.length > 3, '2.4.2: no title');
  expect(document.querySelectorAll('main').length === 1 && document.querySelector('nav'), '1.3.1: no landmarks');
  // Headings go down one level at a time.
  let last = 0;
  for (const heading of document.querySelectorAll('main h1, main h2, main h3, main h4')) {
    const level = Number(heading.tagName[1]);
    expect(level <= last + 1, `1.3.1: ${words(heading)} after a heading of level ${last}`);
    last = level;
  }
  expect(document.querySelectorAll('h1').length === 1, '1.3.1: not one h1');
  // Identifiers are unique.
  const ids = [...document.querySelectorAll('[id]')].map((e) => e.id);
  expect(new Set(ids).size === ids.length, '4.1.1: an identifier twice');
  // Whatever can be used has a name; nothing takes the focus out of its turn.
  const usable = 'a[href], button, input, select, summary, [tabindex]';
  for (const element of document.querySelectorAll(usable)) {
    const label = element.getAttribute('aria-label') ?? element.labels?.[0]?.textContent ?? element.textContent;
    expect(label.trim() !== '' || element.id === 'record-title', `4.1.2: no name: ${words(element)}`);
    expect(element.tabIndex <= 0, `2.4.3: takes the focus before its turn: ${words(element)}`);
  }
  for (const svg of document.querySelectorAll('figure svg:not([aria-hidden])')) {
    expect(svg.getAttribute('aria-label')?.length > 5, '1.1.1: a figure without a name');
  }
  for (const table of document.querySelectorAll('table')) {
    expect(table.caption?.textContent.length > 2, '1.3.1: a table without a caption');
    expect([...table.tHead.querySelectorAll('th')].every((th) => th.scope === 'col'), '1.3.1: a title without a scope');
  }
  // Contrast of text, 4.5 to 1; of marks and lines, 3 to 1.
  const colour = (text) => text.match(/[\d.]+/g).map(Number);
  const luminance = (rgb) => {
    const [r, g, b] = rgb.slice(0, 3).map((c) => c / 255).map((c) => (c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const behind = (element) => {
    for (let e = element; e !== null; e = e.parentElement) {
      const paper = colour(getComputedStyle(e).backgroundColor);
      if (paper.length < 4 || paper[3] > 0) return luminance(paper);
    }
    return 1;
  };
  const contrast = (ink, element) => {
    const [a, b] = [luminance(colour(ink)), behind(element)];
    return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
  };
  const told = new Set();
  const tell = (rule, element, ratio) => {
    const what = `${rule}: contrast ${ratio.toFixed(1)} of ${element.tagName.toLowerCase()}.${element.getAttribute('class') ?? ''}`;
    if (!told.has(what)) { told.add(what); found.push(what); }
  };
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  let texts = 0;
  while (walker.nextNode()) {
    const element = walker.currentNode.parentElement;
    if (walker.currentNode.data.trim() === '' || element.closest('script, style, noscript, dialog:not([open]), #hint') || !seen(element)) continue;
    ++texts;
    const style = getComputedStyle(element);
    const ratio = contrast(element instanceof SVGElement ? style.fill : style.color, element);
    if (ratio < 4.5) tell('1.4.3', element, ratio);
  }
  expect(texts > 200, 'hardly any text was asked');
  for (const series of document.querySelectorAll('figure .series[data-c]')) {
    const ratio = contrast(getComputedStyle(series).color, series);
    if (ratio < 3) tell('1.4.11', series, ratio);
  }
  // What a finger presses: 24 pixels, unless it stands in a line of text or of a table (2.5.8 of WCAG 2.2).
  for (const button of document.querySelectorAll('.legend button, .zoom button, .tools select, .tools input')) {
    const box = button.getBoundingClientRect();
    if (seen(button)) expect(box.width >= 23.5 && box.height >= 23.5, `2.5.8: ${words(button)} is ${box.width.toFixed(0)} x ${box.height.toFixed(0)}`);
  }
  return found;
})()"""


def without_repetitions(browser):
    """Takes rows and scenes that repeat others out of the page: thousands of cells cost axe-core minutes."""
    browser.ask("""for (const body of document.querySelectorAll('tbody')) for (const row of [...body.rows].slice(8)) row.remove();
        for (const scene of document.querySelectorAll('section.scene, .scenes > div')) if (!/sdof-stop/.test(scene.innerHTML)) scene.remove();""")


def findings_of_ours(browser):
    """What is wrong, by our rules in the page and by the names that the browser itself gives to screen readers."""
    found = browser.ask(ASKED)
    roles = {"link", "button", "combobox", "searchbox", "textbox", "figure", "table", "dialog", "navigation"}
    for node in browser.send("Accessibility.getFullAXTree")["nodes"]:
        role, name = node.get("role", {}).get("value"), node.get("name", {}).get("value", "")
        if not node.get("ignored") and role in roles - {"figure"} and not name.strip():
            found.append(f"4.1.2: a {role} without a name")
    return sorted(set(found))


def findings_of_axe(browser, file):
    """What axe-core finds serious or critical."""
    browser.ask(Path(file).read_text(encoding="utf-8") + "; true")
    return browser.ask("""axe.run({ resultTypes: ['violations'] }).then(({ violations }) => violations
        .filter(({ impact }) => impact === 'serious' || impact === 'critical')
        .map(({ id, nodes }) => `${id}: ${nodes.length} times, first ${nodes[0].html.slice(0, 160)} ${nodes[0].failureSummary.slice(0, 200)}`))""")
