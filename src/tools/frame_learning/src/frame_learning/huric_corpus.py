"""Reads HuRIC 2.1 (Human-Robot Interaction Corpus): one command in one ``.hrc`` file, XML.

Bastianelli, Castellucci, Croce, Iocchi, Basili, Nardi: "HuRIC: a Human Robot Interaction Corpus", LREC 2014.
"""

import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import List, Tuple

from frame_learning.annotated_commands import (
    AnnotatedCommand,
    AnnotatedElement,
    AnnotatedFrame,
    CorpusError,
    command_of,
)


def read_huric(folder: str) -> Tuple[AnnotatedCommand, ...]:
    """Read all commands below a folder, in the order of the paths.

    Raises:
        CorpusError: there are no such files, or one of them is not HuRIC XML
    """
    commands: List[AnnotatedCommand] = []
    for path in sorted(Path(folder).glob("**/*.hrc")):
        try:
            root = ElementTree.parse(str(path)).getroot()
            commands += [_command(path.stem, node) for node in root.iter("command")]
        except (ElementTree.ParseError, OSError, KeyError, ValueError) as error:
            raise CorpusError(f"{path}: no HuRIC XML: {error!r}") from error
    if not commands:
        raise CorpusError(f"{folder}: no *.hrc file below; expected a folder of HuRIC 2.1")
    return tuple(commands)


def _command(name: str, node: ElementTree.Element) -> AnnotatedCommand:
    tokens = [token.attrib["surface"] for token in node.findall("tokens/token")]
    frames = [_frame(frame) for frame in node.findall("semantics/frames/frame")]
    return command_of(name, (node.findtext("sentence") or "").strip(), tokens, frames)


def _frame(node: ElementTree.Element) -> AnnotatedFrame:
    return AnnotatedFrame(
        name=node.attrib["name"],
        lexical_unit=tuple(int(token.attrib["id"]) for token in node.findall("lexicalUnit/token")),
        elements=tuple(
            AnnotatedElement(
                name=element.attrib["type"],
                tokens=frozenset(int(token.attrib["id"]) for token in element.findall("token")),
                head=int(element.attrib["semanticHead"]) if element.get("semanticHead") else None,
            )
            for element in node.findall("frameElements/frameElement")
        ),
    )
