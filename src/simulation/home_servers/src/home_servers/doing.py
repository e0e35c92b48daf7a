"""What the robot is doing, in words: "going to the kitchen", "looking for the keys in the bedroom"."""

from pathlib import Path
from typing import Mapping, Optional

import yaml

from home_servers.memory import Known, Memory
from roboframenet_sim.home_actions import Action
from typed_arguments import TypedArgument
from word_classes import without_determiner

#: Of the actions that a person sees; `theme` and `goal` stand for the names of what they are about.
_WORDS: Mapping[str, str] = yaml.safe_load(Path(__file__).resolve().with_name("doing.yaml").read_text(encoding="utf-8"))


def doing(action: Action, memory: Memory) -> str:
    """Return what an action is, in words; empty for one that says nothing to a person."""
    words = _WORDS.get(action.kind, "")
    names = {"theme": action.theme, "goal": action.goal}
    if any(f"{{{name}}}" in words and memory.get(ident) is None for name, ident in names.items()):
        return ""
    known = {name: _the_name(memory.get(ident)) for name, ident in names.items()}
    return words.format(relation=action.relation.replace("_", " "), **known)


def looking_for(argument: TypedArgument, place: Known) -> str:
    """Return that the robot looks for what an argument means, and where."""
    text = argument.text or argument.head
    bare = without_determiner(text)
    # "My keys" are the keys for who looks for them.
    what = text if bare == text or text.lower().startswith(("a ", "an ", "some ")) else f"the {bare}"
    return f"looking for {what} {'in' if place.sort == 'room' else 'at'} {place.the_name}"


def _the_name(one: Optional[Known]) -> str:
    return "" if one is None else one.the_name
