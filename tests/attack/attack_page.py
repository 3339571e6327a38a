"""results/attack.md: what was attacked, how often, and what did not hold."""

import pathlib

INTRODUCTION = """# The program under attack

What a stranger, an accident or a full disk can do to the program, counted: `tests/attack/` makes the inputs from a seed,
runs the built program on them and holds every call to what [SECURITY.md](../SECURITY.md) promises. A violation is a
crash, a call that does not end in its time or its memory, an undocumented exit code, a number that is none in an output,
a refusal of more than one line, a raw byte on the terminal, a lost or doubled record, or an answer called converged that
is none.

This page is made by one command, with a build with sanitizers (of the preset `asan`, or of `fuzz`, whose fuzzers `fuzz.py`
runs, with `-DSIGNORINI_SANITIZE=ON`):

    {command}

Seed {seed}; share `{share}`{sanitized}. Programs: {versions}.
"""
WHAT_FUZZERS_DO = """The readers of untrusted text under libFuzzer, with the sanitizers of addresses and undefined behaviour;
an input may take 25 s and 4 GiB. Time is that of the processor, of all the commits named.
"""


def table(rows):
    """Rows as a Markdown table, the first of them its head."""
    width = len(rows[0])
    lines = [rows[0], ["---"] * width, *([*row, *[""] * (width - len(row))] for row in rows[1:])]
    return "".join("| " + " | ".join(str(cell).replace("|", "\\|") for cell in line) + " |\n" for line in lines)


def campaign_rows(campaigns):
    yield ["what", "tests", "violations", "exit codes", "longest call [s]", "largest process [MiB]"]
    for campaign in campaigns:
        codes = ", ".join(f"{number} x {code}" for code, number in sorted(campaign.codes.items()))
        yield [campaign.what, campaign.tests, len(campaign.violations), codes,
               f"{campaign.seconds:.1f}" if campaign.seconds else "", f"{campaign.peak_mb:.0f}" if campaign.peak_mb else ""]


def fuzzer_rows(entries):
    """A row for each reader: the sums over the programs that were fuzzed, with their commits."""
    for reader in dict.fromkeys(entry["reader"] for entry in entries):
        own = [entry for entry in entries if entry["reader"] == reader]
        yield [reader, ", ".join(dict.fromkeys(entry["commit"] for entry in own)), sum(entry["executions"] for entry in own),
               f"{sum(entry['seconds'] for entry in own):.0f}", sum(len(entry["findings"]) for entry in own),
               ", ".join(entry["mended"] for entry in own if "mended" in entry), max(entry["peak_mb"] for entry in own)]


def versions_of(campaigns):
    """The programs that were attacked, with the campaigns of each where there are several."""
    names = {}
    for campaign in campaigns:
        names.setdefault(campaign.version, {})[campaign.name] = None
    if len(names) == 1:
        return next(iter(names))
    return "; ".join(f"{version} ({', '.join(own)})" for version, own in names.items())


def page_of(campaigns, fuzzed, arguments):
    """The page as Markdown."""
    sanitized = ", the program built with sanitizers" if arguments.sanitized else ""
    program = "/".join(pathlib.Path(arguments.program).resolve().parts[-4:])  # build/PRESET/harness/signorini
    command = f"python3 tests/attack/attack.py {program}"
    command += f" --share {arguments.share}{' --sanitized' if arguments.sanitized else ''} --table results/attack.md"
    command += " --record results/attack.json" if arguments.record else ""
    page = INTRODUCTION.format(command=command, versions=versions_of(campaigns), seed=arguments.seed,
                               share=arguments.share, sanitized=sanitized)
    tests, violations = sum(c.tests for c in campaigns), sum(len(c.violations) for c in campaigns)
    page += f"\n## Tests and counts\n\n{tests} tests, {violations} violations.\n\n" + table(list(campaign_rows(campaigns)))
    found = [text for campaign in campaigns for text in campaign.violations]
    if found:
        lines = (text.encode("ascii", "backslashreplace").decode()[:400] for text in found)
        page += "\n## Violations\n\n" + "".join(f"- `{line}`\n" for line in lines)
    if fuzzed:
        rows = [["reader", "commits", "inputs", "time of the processor [s]", "crashes, hangs and broken promises",
                 "mended by", "largest process [MiB]"]]
        rows += fuzzer_rows(fuzzed)
        page += f"\n## Fuzzers\n\n{WHAT_FUZZERS_DO}\n" + table(rows)
    for title, rows in (note for campaign in campaigns for note in campaign.notes):
        page += f"\n## {title}\n\n" + table(rows) if rows else f"\n{title}.\n"
    return page
