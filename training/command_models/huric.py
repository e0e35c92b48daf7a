"""Scoring against HuRIC 2.1: robot commands with Stanford typed dependencies (basic) and semantic frames.

A parser made HuRIC's trees, and not all were corrected: "please" is the root of some and a noun in others. The score
therefore uses the *lexical units* of the annotated frames, which people chose:

* predicate: the root of our tree is the lexical unit that the gold tree puts highest (in gold trees whose
  root is no lexical unit: the first lexical unit of the command);
* attachment: of the gold dependants of lexical units (subject, objects, particle, prepositional phrases),
  those that our tree hangs on the same word in the same relation, with the same preposition.
"""

import importlib
import sys
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass
from pathlib import Path
from typing import Callable, Dict, FrozenSet, Iterable, List, Set, Tuple

from .conllu import Sentence, render
from .errors import TrainingError

Reader = Callable[[Sentence], Dict[Tuple[int, int], Set[str]]]
Arc = Tuple[int, int, str]  # governor, dependant, relation; places are 1-based

_SAME = {"dobj": "dobj", "dojb": "dobj", "iobj": "iobj", "nsubj": "nsubj", "prt": "prt", "nsubjpass": "nsubj"}
_OURS = {"obj": "dobj", "iobj": "iobj", "nsubj": "nsubj", "nsubj:pass": "nsubj", "compound:prt": "prt"}
# HuRIC's names for relations that the rules name otherwise: it has no vocative and no separate passive subjects.
_RENAMED = {"vocative": "nsubj", "nsubjpass": "nsubj"}
_DIRECTIONS = frozenset("left right back down up off on forward backward over away".split())


@dataclass(frozen=True)
class Command:
    """One HuRIC command: its tokens, its gold arcs, the places of the lexical units of its frames."""

    name: str
    tokens: Tuple[str, ...]
    tags: Tuple[str, ...]
    arcs: Tuple[Arc, ...]
    units: FrozenSet[int]

    def predicate(self) -> int:
        """Position of the gold predicate, 0 when no lexical unit is annotated."""
        heads = {dependant: governor for governor, dependant, _ in self.arcs}
        roots = [dependant for governor, dependant, relation in self.arcs if relation == "root"]
        if roots and roots[0] in self.units:
            return roots[0]
        return min(self.units, default=0) if self.units else (roots[0] if roots and not heads.get(roots[0]) else 0)


def read_folder(folder: Path) -> List[Command]:
    """Read all commands under a HuRIC folder (``*.hrc``), in the order of their paths.

    Raises TrainingError when there are none, or when a file is no HuRIC XML.
    """
    commands: List[Command] = []
    for path in sorted(folder.glob("**/*.hrc")):
        try:
            root = ElementTree.parse(str(path)).getroot()
        except ElementTree.ParseError as error:
            raise TrainingError(f"{path}: not well-formed XML: {error}") from error
        for command in root.iter("command"):
            tokens = command.findall("tokens/token")
            arcs = tuple(
                (int(arc.get("from", "0")), int(arc.get("to", "0")), arc.get("type", ""))
                for arc in command.findall("dependencies/dep")
            )
            tags = tuple(token.get("pos", "") for token in tokens)
            units: Set[int] = set()
            for frame in command.findall("semantics/frames/frame"):
                places = {int(token.get("id", "0")) for token in frame.findall("lexicalUnit/token")}
                # of several words ("there is", "look for"), the one that governs the others
                heads = [dependant for governor, dependant, _ in arcs if dependant in places and governor not in places]
                if places:
                    units.add(min(heads) if heads else min(places))
            commands.append(
                Command(path.stem, tuple(token.get("surface", "") for token in tokens), tags, arcs, frozenset(units))
            )
    if not commands:
        raise TrainingError(f"{folder}: no *.hrc file below; expected a folder of HuRIC 2.1")
    return commands


def gold_arguments(command: Command) -> Set[Arc]:
    """The gold arguments of the lexical units; prepositional phrases as ``prep_<preposition>`` on their noun."""
    found: Set[Arc] = set()
    objects: Dict[int, int] = {}
    for governor, dependant, relation in command.arcs:
        if relation in ("pobj", "pcomp"):
            objects[governor] = dependant
    for governor, dependant, relation in command.arcs:
        if governor not in command.units:
            continue
        if relation in _SAME:
            found.add((governor, dependant, _SAME[relation]))
        elif relation == "prep" and dependant in objects:
            found.add((governor, objects[dependant], "prep_" + command.tokens[dependant - 1].lower()))
    return found


def our_arguments(sentence: Sentence) -> Dict[Tuple[int, int], Set[str]]:
    """For each governor and dependant of our tree, the Stanford relations that it stands for."""
    found: Dict[Tuple[int, int], Set[str]] = {}
    copulas: Dict[int, int] = {}
    cases: Dict[int, List[int]] = {}
    for place, word in enumerate(sentence.words, 1):
        if word.deprel == "cop":
            copulas[word.head] = place
        if word.deprel == "case":
            cases.setdefault(word.head, []).append(place)

    def add(governor: int, dependant: int, relation: str) -> None:
        found.setdefault((governor, dependant), set()).add(relation)

    for place, word in enumerate(sentence.words, 1):
        governor = word.head
        prepositions = [sentence.words[at - 1].form.lower() for at in cases.get(place, [])]
        # "the cup is on the table": Stanford makes "is" the root, UD the table
        if governor in copulas and governor in cases and word.deprel.startswith("nsubj"):
            governor = copulas[governor]
        if place in copulas and prepositions:
            add(copulas[place], place, "prep_" + prepositions[-1])
        if word.deprel in _OURS:
            add(governor, place, _OURS[word.deprel])
        if word.deprel in ("obl:unmarked", "advmod") or (word.deprel in ("obl", "obj") and not prepositions):
            # some parsers make a bare measure or direction an object, others an adverb
            for relation in ("dobj", "iobj", "tmod", "npadvmod"):
                add(governor, place, relation)
        if word.deprel == "vocative":
            add(governor, place, "nsubj")  # HuRIC's scheme has no vocative and writes nsubj
        if word.deprel == "advcl":
            for marker in sentence.words:
                if marker.head == place and marker.deprel == "mark":
                    add(governor, place, "prep_" + marker.form.lower())
        if word.deprel in ("advmod", "compound:prt") and word.form.lower() in _DIRECTIONS:
            add(governor, place, "prt")
        for preposition in prepositions:
            add(governor, place, "prep_" + preposition)
    return found


def runtime_arguments(source: Path) -> "Reader":
    """The same by the rule table that robots run: ``source`` is the folder that holds ``stanford_parser_ros``, in the
    source tree; the package ``utterance_passes`` lies in a folder beside that one, or above.

    Raises TrainingError when there is no such package in it.
    """
    if not (source / "stanford_parser_ros" / "stanford_dependencies.py").is_file():
        raise TrainingError(f"{source}: no stanford_parser_ros/stanford_dependencies.py below")
    above = source.resolve().parents[1:3]
    passes = [path for one in above for path in (one / "utterance_passes" / "src", *one.glob("*/utterance_passes/src"))]
    sys.path[:0] = [str(source.resolve()), *(str(path) for path in passes if path.is_dir())]
    conllu = importlib.import_module("utterance_passes.trees.conllu")
    rules = importlib.import_module("stanford_parser_ros.stanford_dependencies")

    def read(sentence: Sentence) -> Dict[Tuple[int, int], Set[str]]:
        found: Dict[Tuple[int, int], Set[str]] = {}
        for arc in rules.arcs(conllu.from_conllu(render(sentence))):
            names = {_RENAMED.get(name, name) for name in arc.relations}
            found.setdefault((arc.governor, arc.dependent), set()).update(names)
        return found

    return read


@dataclass(frozen=True)
class Score:
    """Counts over commands: right predicates, right arguments, and one line for each error."""

    commands: int
    predicates: int
    arguments: int
    attached: int
    failures: Tuple[str, ...]

    def percent(self) -> Dict[str, float]:
        """Figures for the model card."""
        return {
            f"predicate right (of {self.commands})": 100.0 * self.predicates / max(1, self.commands),
            f"arguments attached right (of {self.arguments})": 100.0 * self.attached / max(1, self.arguments),
        }

    def lines(self) -> List[str]:
        """Return the score as text for people."""
        predicates, arguments = self.percent().values()
        return [
            f"predicate right: {self.predicates} of {self.commands} ({predicates:.1f} %)",
            f"arguments attached right: {self.attached} of {self.arguments} ({arguments:.1f} %)",
        ]


def our_root(sentence: Sentence) -> int:
    """Return the root of our tree in Stanford dependencies: a copula before a prepositional predicate."""
    root = next(place for place, word in enumerate(sentence.words, 1) if word.head == 0)
    copula = 0
    marked = False
    for place, word in enumerate(sentence.words, 1):
        if word.head == root and word.deprel == "cop":
            copula = place
        if word.head == root and word.deprel == "case":
            marked = True
    return copula if copula and marked else root


def score(commands: Iterable[Command], parsed: Iterable[Sentence], read: "Reader" = our_arguments) -> Score:
    """Compare gold commands with our trees of the same tokens, in the same order.

    ``read`` names the Stanford relations in a tree of ours: the short table here, or the runtime's rules.
    """
    total = predicates = arguments = attached = 0
    failures: List[str] = []
    for command, sentence in zip(commands, parsed):
        text = " ".join(command.tokens)
        wanted = command.predicate()
        if wanted:
            total += 1
            root = our_root(sentence)
            # "this is a bathroom": the frame's unit is the copula, both schemes head the noun
            copulas = {
                place for place, word in enumerate(sentence.words, 1) if word.deprel == "cop" and word.head == root
            }
            if wanted == root or wanted in copulas:
                predicates += 1
            else:
                failures.append(f"predicate {command.tokens[wanted - 1]}, not {sentence.words[root - 1].form}: {text}")
        ours = read(sentence)
        for governor, dependant, relation in sorted(gold_arguments(command)):
            arguments += 1
            if relation in ours.get((governor, dependant), set()):
                attached += 1
                continue
            word = sentence.words[dependant - 1]
            failures.append(
                "{}({}, {}), ours {} of {}: {}".format(
                    relation,
                    command.tokens[governor - 1],
                    command.tokens[dependant - 1],
                    word.deprel,
                    sentence.words[word.head - 1].form if word.head else "ROOT",
                    text,
                )
            )
    return Score(total, predicates, arguments, attached, tuple(failures))
