"""A page of Markdown as a bash script: its shell blocks, the files that it shows, and the output that it promises.

=====================  =========================================================================
first line of a block  what it is
=====================  =========================================================================
bash                   commands; each has to succeed
bash status=N          commands, the last of which exits with N
bash background        runs on until the page ends; the block behind it may have to wait for it
text                   what the block before it prints; "..." stands for anything
LANGUAGE PATH          a file to write
another one            is shown only
=====================  =========================================================================
"""

import re
import shlex
from dataclasses import dataclass
from pathlib import Path
from typing import Iterator, List

_BLOCK = re.compile(r"^```(?P<info>[^\n]*)\n(?P<text>.*?)^```$", re.MULTILINE | re.DOTALL)
#: A block that needs another one to be up is repeated for so long, seconds.
PATIENCE_S = 120


@dataclass(frozen=True)
class Block:
    """A block of a page.

    Attributes:
        language: "bash", "text", "yaml", ...; empty for none
        option: what follows the language in its first line
        text: with a line end
        line: of the page, from 1
    """

    language: str
    option: str
    text: str
    line: int


@dataclass(frozen=True)
class Step:
    """A shell block, the status that it ends with, and the pattern of what it prints."""

    block: Block
    output: "re.Pattern[str]"


def blocks(text: str) -> Iterator[Block]:
    """Yield the blocks of a page."""
    for found in _BLOCK.finditer(text):
        language, _, option = found.group("info").strip().partition(" ")
        yield Block(language, option.strip(), found.group("text"), text.count("\n", 0, found.start()) + 1)


def steps(text: str) -> List[Step]:
    """Return the shell blocks of a page with what they print."""
    found: List[Step] = []
    for block in blocks(text):
        if block.language == "bash":
            found.append(Step(block, pattern_of("...\n")))
        elif block.language == "text":
            found[-1] = Step(found[-1].block, pattern_of(block.text))
    return found


def pattern_of(text: str) -> "re.Pattern[str]":
    """Return the pattern of an output: a line "..." stands for any lines, "..." in a line for any characters."""
    lines = []
    for line in text.splitlines():
        if line.strip() == "...":
            lines.append(r"(?:.*\n)*?")
        else:
            lines.append(".*".join(map(re.escape, line.rstrip().split("..."))) + r"\s*\n")
    return re.compile("".join(lines))


def script_of(text: str, folder: Path, environment: str = "") -> str:
    """Return the bash script of a page.

    Args:
        text: of the page
        folder: for the blocks and their output: N.sh and N.out, N counted from 0
        environment: commands that come first
    """
    lines = ["set -e", "trap 'kill $(jobs -p) 2>/dev/null || true' EXIT", environment]
    number, is_waiting = 0, False
    for block in blocks(text):
        if block.language == "bash":
            path, output = folder / f"{number}.sh", folder / f"{number}.out"
            path.write_text(block.text, encoding="utf-8")
            lines.append(f"echo {number} > {folder}/reached")
            lines += _run(block, path, output, is_waiting=is_waiting)
            is_waiting = block.option == "background"
            number += 1
        elif block.option and block.language != "text":
            path = Path(block.option)
            lines.append(f"mkdir -p {shlex.quote(str(path.parent))}")
            lines.append(f"cat > {shlex.quote(str(path))} <<'END_OF_FILE'\n{block.text}END_OF_FILE")
    return "\n".join(lines) + f"\necho done > {folder}/reached\n"


def _run(block: Block, path: Path, output: Path, *, is_waiting: bool) -> List[str]:
    if block.option == "background":
        return [f"bash -e {path} > {output} 2>&1 &"]
    status = int(block.option.partition("status=")[2] or "0")
    if status or is_waiting:
        # In a shell of its own: what it exports is lost.
        attempt = f"bash -e {path} > {output} 2>&1 && found=0 || found=$?"
        once = f"[ $found -eq {status} ] || exit 1"
        if not is_waiting:
            return [attempt, once]
        return [
            f"for ((end = SECONDS + {PATIENCE_S}; ; )); do",
            f"  {attempt}",
            f"  [ $found -ne {status} ] || break",
            "  [ $SECONDS -lt $end ] || exit 1",
            "  sleep 0.5",
            "done",
        ]
    # The setup files of catkin are not written for a shell that exits on errors.
    path.write_text(re.sub(r"(?m)^(source .*)$", r"set +e; \1; set -e", block.text), encoding="utf-8")
    return [f". {path} > {output} 2>&1"]
