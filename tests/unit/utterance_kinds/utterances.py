"""The generated set of utterances, by kind: templates times the examples of all units.

The rules are tuned on the set "tune"; the set "frozen" was put aside before the first rule was written.
"""

import random
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, Iterator, List, Tuple

import yaml

from .inflection import inflect_clause

FOLDER = Path(__file__).resolve().parent
SETS = ("tune", "frozen")
SEED = 2012
#: Number of clauses for each template.
CLAUSES_PER_TEMPLATE = {False: 12, True: 20}

_SLOT = re.compile(r"\{(\w+)\}")
#: Pronouns that change when the speaker acts: "give me the mug" becomes "I gave you the mug".
_TURNED_AROUND = {"me": "you", "us": "you", "my": "your", "your": "my", "you": "me"}
_PRONOUN = re.compile(rf"\b({'|'.join(_TURNED_AROUND)})\b")
_PREPOSITION = re.compile(r" (in|on|of|near|from|with) ")
#: "He stands next to the desk" and "I am standing near the mirror" say where somebody is, which a robot may note.
_POSTURES = ("stand near ", "stand next ", "stand between ")
_SINGULAR_IN_S = frozenset(["gas", "dress", "this"])


@dataclass(frozen=True)
class Clause:
    """A plain command of one clause, such as "put the mug on the table", without politeness and final mark.

    Attributes:
        frame_name: frame of the unit whose example it is
        text: the command; lower case but for names
        object: the subject of its passive; empty if there is no natural passive
    """

    frame_name: str
    text: str
    object: str


@dataclass(frozen=True)
class Template:
    """Words around a clause; the head of ``templates_tune.yaml`` explains the fields."""

    set: str
    kind: str
    acts: bool
    performer: str
    mark: str
    template: str
    distinct: bool = False

    @property
    def slots(self) -> Tuple[str, ...]:
        """Names of the slots, in order."""
        return tuple(_SLOT.findall(self.template))


@dataclass(frozen=True)
class Style:
    """How an utterance is written; a speech recogniser gives neither capitals nor final punctuation."""

    capitals: bool
    final_mark: bool

    def write(self, text: str, mark: str) -> str:
        """Return a text in this style."""
        text = text[:1].upper() + text[1:] if self.capitals else text.lower()
        return text + mark if self.final_mark else text


STYLES = (Style(True, True), Style(False, False), Style(True, False), Style(False, True))


@dataclass(frozen=True)
class Utterance:
    """An utterance, and its plain command in the same style."""

    template: Template
    clause: Clause
    style: Style

    @property
    def text(self) -> str:
        """The words of the utterance."""
        return self.style.write(fill(self.template, self.clause), self.template.mark)

    @property
    def plain_command(self) -> str:
        """The command that the utterance is made of."""
        return self.style.write(self.clause.text, ".")


def load_clauses() -> Tuple[Clause, ...]:
    """Read the clauses of ``clauses.tsv``."""
    lines = (FOLDER / "clauses.tsv").read_text(encoding="utf-8").splitlines()[1:]
    return tuple(Clause(*line.split("\t")) for line in lines)


def load_templates(which: str) -> Tuple[Template, ...]:
    """Read the templates of a set, "tune" or "frozen"."""
    entries = yaml.safe_load((FOLDER / f"templates_{which}.yaml").read_text(encoding="utf-8"))
    return tuple(
        Template(template=text, **{key: value for key, value in entry.items() if key != "templates"})
        for entry in entries
        for text in entry["templates"]
    )


def fits(template: Template, clause: Clause) -> bool:
    """Whether a clause fits a template and keeps the kind of the template."""
    if "passive" in template.slots and not clause.object:
        return False
    if not template.acts and {"third", "gerund"} & set(template.slots) and clause.text.startswith(_POSTURES):
        return False
    forms = inflect_clause(clause.text)
    return not template.distinct or forms.past != forms.base


def fill(template: Template, clause: Clause) -> str:
    """Return a template filled with a clause, without capital and final punctuation."""
    slots = _slots(clause)
    if template.performer == "speaker":
        slots = {name: _PRONOUN.sub(lambda word: _TURNED_AROUND[word.group()], text) for name, text in slots.items()}
    return template.template.format(**slots)


def _slots(clause: Clause) -> Dict[str, str]:
    forms = inflect_clause(clause.text)
    slots = {
        "base": forms.base,
        "third": forms.third,
        "past": forms.past,
        "participle": forms.participle,
        "gerund": forms.gerund,
    }
    if clause.object:
        noun = _PREPOSITION.split(clause.object)[0].split()[-1]
        plural = " and " in clause.object or (noun.endswith("s") and noun not in _SINGULAR_IN_S)
        slots["object"] = clause.object
        slots["passive"] = " ".join(forms.participle.replace(clause.object, "", 1).split())
        slots.update(zip(("has", "was", "is"), ("have", "were", "are") if plural else ("has", "was", "is")))
    return slots


def generate(which: str, *, seed: int = SEED) -> Tuple[Utterance, ...]:
    """Return the utterances of a set: each template, each clause and each style is used.

    Args:
        which: "tune" or "frozen"
        seed: seed for the choice of clauses
    """
    chance = random.Random(seed)
    clauses = load_clauses()
    decks: Dict[bool, List[Clause]] = {False: [], True: []}
    utterances = []
    for template in load_templates(which):
        drawn = _draw(template, clauses, decks[template.acts], chance)
        utterances += [Utterance(template, clause, STYLES[n % len(STYLES)]) for n, clause in enumerate(drawn)]
    return tuple(dict.fromkeys(utterances))


def _draw(
    template: Template, clauses: Tuple[Clause, ...], deck: List[Clause], chance: random.Random
) -> Iterator[Clause]:
    """Take clauses that fit from the deck; when none is left, shuffle it again, so that all are used."""
    for _ in range(CLAUSES_PER_TEMPLATE[template.acts]):
        if not any(fits(template, clause) for clause in deck):
            deck.extend(chance.sample(clauses, len(clauses)))
        position = next(n for n, clause in enumerate(deck) if fits(template, clause))
        yield deck.pop(position)


def sample(utterances: Tuple[Utterance, ...], count: int, *, seed: int = SEED) -> Tuple[Utterance, ...]:
    """Return some of the utterances, from as many templates as possible."""
    shuffled = random.Random(seed).sample(utterances, len(utterances))
    first_of_template = {utterance.template: utterance for utterance in reversed(shuffled)}
    firsts = list(first_of_template.values())
    chosen = frozenset(firsts)
    return tuple((firsts + [utterance for utterance in shuffled if utterance not in chosen])[:count])
