"""Our own annotated commands, and the slots of the home."""

import os
from pathlib import Path
from typing import Any, Dict, Tuple

import yaml

from roboframenet_testing.workspace import package

from .commands import Command
from .home_slots import HomeSlots
from .logical_forms import read_form

_HERE = os.path.dirname(os.path.realpath(__file__))
HOME_FILE = str(package("roboframenet_sim") / "config" / "home.yaml")
#: Sayings when no grammar names any.
_SAYINGS = ("the time", "the day of the week")


def read_home() -> Dict[str, Any]:
    """Return the content of the home file."""
    with open(HOME_FILE, encoding="utf-8") as file:
        return dict(yaml.safe_load(file))


def slots_of(folder: str, *, speaker: str) -> HomeSlots:
    """Return the values of slots for the grammars with logical forms of a folder; without a folder, our own."""
    paths = [path.parent / "whattosay.txt" for path in sorted(Path(folder).rglob("*_semantics.txt"))] if folder else []
    said = [line.strip() for path in paths if path.exists() for line in path.read_text(encoding="utf-8").splitlines()]
    return HomeSlots(read_home(), speaker=speaker, sayings=tuple(dict.fromkeys(one for one in said if one)) or _SAYINGS)


def read_annotated() -> Tuple[Command, ...]:
    """Read our own commands."""
    with open(os.path.join(_HERE, "commands.yaml"), encoding="utf-8") as file:
        entries = yaml.safe_load(file)
    return tuple(
        Command(
            one["say"],
            read_form(one["form"]),
            "our own",
            one.get("arranged", {}),
            destination=one.get("destination", ""),
        )
        for one in entries
    )
