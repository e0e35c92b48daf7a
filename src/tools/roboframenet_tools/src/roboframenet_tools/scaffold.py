"""The files of a new ability: frame, lexical unit, RFNServer, test; and of the package that holds them."""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, List, Optional, Sequence, Tuple

#: Whole files, beside this module in the source, devel and install space; in braces what ``str.format`` fills in.
_TEMPLATES = Path(__file__).resolve().parent / "templates"
_CALLBACK = '''def {name}(frame):
    """Do it; a goal that is not ended here succeeds, an exception aborts it with its text."""
    rospy.loginfo("{verb}: %s", argument(frame, "{element}"))'''
_EXECUTE = '''def execute(goal):
    """Do it; end the goal with set_succeeded, set_aborted (text= says why) or set_preempted."""
    rospy.loginfo("{verb}: %s", goal)
    server.set_succeeded()'''
_NODE = '  <node pkg="{package}" type="{name}_server" name="{name}_server" respawn="$(arg respawn)" output="screen"/>'
_NAME = re.compile(r"[a-z][a-z0-9_]*")
_VERB = re.compile(r"[a-z]+( [a-z]+)*")


@dataclass(frozen=True)
class Element:
    """A frame element, and how a first version of the unit fills it.

    Attributes:
        name: of the element
        is_core: whether the frame cannot be understood without it
        quantity: "number", "duration"; empty for words
        values: the only arguments; empty for any
        is_list: whether it holds several things
        relations: that fill it; empty when a person has to choose them
        arguments: of the examples
        examples: sentences, with the verb as "{verb}" or "{Verb}"
    """

    name: str
    is_core: bool = True
    quantity: str = ""
    values: Tuple[str, ...] = ()
    relations: Tuple[str, ...] = ("dobj",)
    arguments: Tuple[str, ...] = ("the box", "the ball", "the red mug")
    examples: Tuple[str, ...] = ("{Verb} the box.", "please {verb} the ball", "Could you {verb} the red mug?")
    is_list: bool = False


#: The element of a frame about which nothing else is known.
THEME = Element("theme")


@dataclass(frozen=True)
class Ability:
    """What is to be written.

    Attributes:
        name: of the frame
        verb: that evokes it, base form, with a particle if it has one
        elements: of the frame, the one of the examples first; none for a frame that needs no words but its verb
        action: package and name of an action type ("nav_msgs", "GetMapAction"); None for a server of frames
        package: the catkin package; empty for a plain folder

    Raises:
        ValueError: a name or the verb has another form
    """

    name: str
    verb: str
    elements: Sequence[Element] = (THEME,)
    action: Optional[Tuple[str, str]] = None
    package: str = ""

    def __post_init__(self) -> None:
        for name, what, example in ((self.name, "a frame", "winking"), (self.package or "x", "a package", "my_robot")):
            if not _NAME.fullmatch(name):
                raise ValueError(
                    f"'{name}' is not the name of {what}: use lower case letters, digits and underscores, such as "
                    f"{example}"
                )
        if not _VERB.fullmatch(self.verb):
            raise ValueError(
                f"'{self.verb}' is not a verb: use lower case words, such as 'pick up' (give it with --verb)"
            )


def ability_files(ability: Ability) -> Dict[str, str]:
    """Return the text of each file of an ability by its path in the folder."""
    name = ability.name
    paths = {
        f"frames/{name}.yaml": _frame(ability),
        f"lexical_units/{name}.yaml": _unit(ability),
        f"nodes/{name}_server": _server(ability),
        f"test/unit/test_{name}.py": _filled("unit_test.py", name=name),
    }
    if ability.package:
        capital = "".join(part.capitalize() for part in name.split("_"))
        words = {"name": name, "package": ability.package, "capital": capital, "sentence": _sentence(ability)}
        paths[f"test/rostest/{name}.test"] = _filled("rostest.test", **words)
        paths[f"test/rostest/{name}_test.py"] = _filled("rostest.py", **words)
    return paths


def package_files(ability: Ability) -> Dict[str, str]:
    """Return the text of each file that a package needs beside those of its first ability."""
    dependencies = f"  <exec_depend>{ability.action[0]}</exec_depend>\n" if ability.action else ""
    return {
        "package.xml": _filled("package.xml", package=ability.package, dependencies=dependencies),
        "CMakeLists.txt": _filled("CMakeLists.txt", package=ability.package),
        f"launch/{ability.package}.launch": _filled(
            "abilities.launch", package=ability.package, nodes=node_line(ability)
        ),
    }


def node_line(ability: Ability) -> str:
    """Return the line of a launch file that starts the server."""
    return _NODE.format(package=ability.package, name=ability.name)


def _filled(template: str, **words: str) -> str:
    """Return the text of a file of which ``templates`` has the pattern."""
    return (_TEMPLATES / f"{template}.template").read_text(encoding="utf-8").format(**words)


def is_program(path: str) -> bool:
    """Whether a file is to be executed."""
    return path.startswith("nodes/") or (path.startswith("test/rostest/") and path.endswith(".py"))


def _said(text: str, verb: str) -> str:
    return text.format(verb=verb, Verb=verb.capitalize())


def _sentence(ability: Ability) -> str:
    """Return a sentence that asks for the ability."""
    return _said(_examples(ability)[0][0], ability.verb)


def _examples(ability: Ability) -> List[Tuple[str, str]]:
    """Return the examples of the unit, each with the elements that it fills."""
    if not ability.elements:
        return [(text, "{}") for text in ("{Verb}.", "please {verb}", "Could you {verb}?")]
    first = ability.elements[0]
    return [(text, f"{{{first.name}: {argument}}}") for text, argument in zip(first.examples, first.arguments)]


def _frame(ability: Ability) -> str:
    lines: List[str] = []
    for element in ability.elements:
        lines += [f"  - name: {element.name}", f"    is_core: {element.is_core}"]
        if element.quantity:
            lines.append(f"    quantity: {element.quantity}")
        if element.values:
            lines.append(f"    values: [{', '.join(element.values)}]")
        if element.is_core:
            words = element.name.replace("_", " ")
            question = (
                f"What should I {ability.verb}?"
                if element == THEME
                else f"What {'are' if element.is_list else 'is'} the {words}?"
            )
            lines += [f"    question: {question}", f"    answer: {element.arguments[0]}"]
    return _filled("frame.yaml", name=ability.name, verb=ability.verb, elements="\n".join(lines or ["  []"]))


def _unit(ability: Ability) -> str:
    special: List[str] = []
    particle = ability.verb.rpartition(" ")[2]
    for element in ability.elements:
        found = list(element.relations)
        if found[:1] == ["dobj"] and particle != ability.verb:
            # "Look after the box": the parser may take the particle for a preposition.
            found.append(f"prep_{particle}")
        if not found:
            special.append(f"  # which words fill {element.name}? 'rfn explain' shows the relations of a sentence")
        elif element.values:
            words = ", ".join(element.values)
            special.append(f"  {element.name}: {{relation: [{', '.join(found)}], words: [{words}]}}")
        elif element.quantity and found != ["measure"]:
            # A number in a phrase is the word itself: "count to seven".
            special.append(f"  {element.name}: {{relation: [{', '.join(found)}], argument: head}}")
        elif not element.quantity and (found != ["dobj"] or not element.is_core):
            special.append(f"  {element.name}: [{', '.join(found)}]")
    examples = [f"  {_key(_said(text, ability.verb))}: {filled}" for text, filled in _examples(ability)]
    return _filled(
        "lexical_unit.yaml",
        name=ability.name,
        verb=ability.verb,
        elements="\n".join(["elements:", *special, ""]) if special else "",
        examples="\n".join(examples),
    )


def _key(text: str) -> str:
    """Return a text as a key of YAML; one with a question mark needs quotation marks in lists only, so it has them."""
    return f'"{text}"' if "?" in text else text


def _server(ability: Ability) -> str:
    words = {
        "name": ability.name,
        "verb": ability.verb,
        "element": ability.elements[0].name if ability.elements else "",
    }
    imports = ["import rospkg", "import rospy"] if ability.package else ["import rospy"]
    folder = 'os.path.join(os.path.dirname(os.path.realpath(__file__)), "..")'
    if ability.package:
        folder = f'rospkg.RosPack().get_path("{ability.package}")'
    if ability.action:
        package, kind = ability.action
        callback = _EXECUTE.format(**words)
        imports += ["from rfnserver import RFNServer", f"from {package}.msg import {kind}"]
        constructor = f'RFNServer("{ability.name}", {kind}, execute_cb=execute, auto_start=False)'
    else:
        callback = _CALLBACK.format(**words)
        imports += ["from rfnserver import RFNServer", "from rfnserver.arguments import argument"]
        constructor = f'RFNServer("{ability.name}", {ability.name})'
    return _filled(
        "server.py",
        imports="\n".join(imports) + "\n",
        folder=folder,
        callback=callback,
        constructor=constructor,
        **words,
    )
