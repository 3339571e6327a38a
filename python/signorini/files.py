"""Files that this package writes."""

from __future__ import annotations

import contextlib
import os
import re
from pathlib import Path

from .program import BadInput

NAME = re.compile("[a-z0-9]+(-[a-z0-9]+)*")
LONGEST_NAME = 64


def require_name(name: str) -> None:
    """Raises BadInput unless the name of a scene or a method is in lower-kebab-case: it becomes the name of a file, and no path."""
    if not NAME.fullmatch(name) or len(name) > LONGEST_NAME:
        raise BadInput(f'name = "{name}" (must be a name in lower-kebab-case, such as "sdof-stop", of at most {LONGEST_NAME} characters)')


def write_whole(file: Path, text: str, encoding: str = "utf-8") -> None:
    """In one piece: a reader sees the old text or the new. A link of that name is replaced, and what it leads to is left alone.
    The folder is looked up once: one that is exchanged meanwhile gets nothing."""
    if str(file.parent) == "/dev":  # root would rename a file over /dev/null
        raise BadInput(f"file = {file} (must be a file, and no device)")
    draft = file.name + ".new"
    folder = os.open(file.parent, os.O_RDONLY | os.O_DIRECTORY)
    try:
        with contextlib.suppress(FileNotFoundError):
            os.unlink(draft, dir_fd=folder)
        descriptor = os.open(draft, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW, 0o666, dir_fd=folder)
        with os.fdopen(descriptor, "w", encoding=encoding) as stream:
            stream.write(text)
            stream.flush()
            os.fsync(stream.fileno())
        os.replace(draft, file.name, src_dir_fd=folder, dst_dir_fd=folder)
    finally:
        os.close(folder)
