"""The records of a run of the benchmark, `signorini run --out FOLDER`. Their keys: docs/records.md."""

from __future__ import annotations

import json
import warnings
from collections.abc import Sequence
from pathlib import Path

from .libraries import library
from .program import BadInput
from .response import flat

LISTS = ("waveforms", "trajectory", "certificate.events", "certificate.floquet", "seconds.rounds", "physics.effective_restitution",
         "response.branches", "response.located", "response.open_ends", "response.comparison")


def load(folder: str | Path) -> list[dict]:
    """The records of a run, in their order, without those that are stale (docs/records.md, The folder of a run).

    A line that is no record is left out with a warning. Raises BadInput where the folder holds no run.
    """
    file, plan = Path(folder, "records.jsonl"), Path(folder, "plan.txt")
    if not file.is_file():
        raise BadInput(f"folder = {folder} (must hold records.jsonl, as `signorini run --out` leaves it)")
    records: dict[str, dict] = {}
    for number, line in enumerate(file.read_text(encoding="utf-8", errors="replace").splitlines(), start=1):
        try:
            record = json.loads(line)
            key, _ = record["key"], record["case"]
        except (ValueError, TypeError, KeyError):
            warnings.warn(f"{file}:{number}: no record; left out", stacklevel=2)
            continue
        records.pop(key, None)  # the last of a key counts
        records[key] = record
    if plan.is_file():
        planned = {line.partition(" ")[0] for line in plan.read_text(encoding="utf-8").splitlines()}
        return [record for key, record in records.items() if key in planned]
    return list(records.values())


def frame(records: str | Path | Sequence[dict]):
    """Records, or those of a folder, as a pandas.DataFrame: one row each, columns flat, as "errors.x_l2" and "seconds.median".

    Lists (waveforms, events, rounds, ..) have no columns. What a record does not have is NaN. Needs pandas.
    """
    pandas = library("pandas", "signorini.frame")
    if isinstance(records, (str, Path)):
        records = load(records)
    return pandas.DataFrame([flat(without_lists(record)) for record in records])


def without_lists(record: dict) -> dict:
    result = {}
    for key, value in record.items():
        if key in LISTS:
            continue
        inner = {part: entry for part, entry in value.items() if f"{key}.{part}" not in LISTS} if isinstance(value, dict) else value
        result[key] = inner
    return result
