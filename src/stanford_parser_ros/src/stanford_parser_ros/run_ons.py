"""Commands that are said one after the other without a mark: "open the cupboard close the drawer".

Speech recognisers give no punctuation, and a parser that learned from text takes the second verb for anything but a
verb. So such an utterance is cut where a known verb with an object of its own begins behind a phrase that is complete,
and each part is parsed alone.
"""

from dataclasses import dataclass, replace
from typing import FrozenSet, List, Sequence, Tuple

from stanford_parser_ros.imperative import LEAD_IN
from stanford_parser_ros.tree import DependencyTree, Word

#: What an object begins with.
_OBJECTS = frozenset(
    "the a an my your his her its our their this that these those some all every both it them me him us".split()
)
#: What belongs to the verb in front of it: "turn *on* the fan".
_PARTICLES = frozenset("up on off down out in back away over".split())
#: A phrase ends with one of these parts of speech.
_COMPLETE = frozenset(["NOUN", "PROPN", "PRON", "NUM", "ADV", "INTJ", "SYM"])
_SUBJECTS = frozenset("i you we he she they who that which there".split())
#: Behind one of these and its object a verb is no command of its own: "let him open the door", "leave the door open".
_WITH_A_VERB = frozenset("let help make have watch see hear notice keep leave hold".split())
#: What is behind one of these is said.
_SAYING = frozenset(
    "say tell ask announce shout whisper call yell inform remind notify declare answer reply repeat name label".split()
)
_BE = frozenset("am is are was were 'm 's 're".split())
_MODALS = frozenset(["can", "could", "will", "would"])
#: Verbs that only lead to the next one.
_LEADING = frozenset(["go", "come", "try", "help"])
#: Words of which one makes no phrase complete.
_OPEN = frozenset(["not", "n't", "never", "to", "very", "so", "too", "please"])


@dataclass(frozen=True)
class TaggedWord:
    """A word, its universal part of speech, and where it begins in the text that was tagged."""

    form: str
    upos: str
    start: int

    @property
    def said(self) -> str:
        """The form in lower case."""
        return self.form.lower()


def cuts(words: Sequence[TaggedWord], verbs: FrozenSet[str]) -> List[int]:
    """Find where further commands begin.

    Args:
        words: of the utterance
        verbs: known verbs in their base form, lower case
    Returns:
        positions of characters, in order
    """
    if any(word.said in _SAYING for word in words):
        return []
    found = []
    for position in range(2, len(words) - 1):
        lead = position
        while lead > 1 and words[lead - 1].said in LEAD_IN - {"and", "then"}:
            lead -= 1
        if _begins_command(words, position, verbs) and _is_complete(words[:lead]):
            found.append(words[lead].start)
    return found


def _begins_command(words: Sequence[TaggedWord], position: int, verbs: FrozenSet[str]) -> bool:
    following = words[position + 1].said
    if words[position].said in _MODALS:
        behind = position + 2 + (position + 2 < len(words) and words[position + 2].said == "please")
        return following == "you" and behind < len(words) and words[behind].said in verbs
    if words[position].said not in verbs or words[position].upos == "AUX":
        return False
    is_phrasal = following in _PARTICLES and position + 2 < len(words) and words[position].upos == "VERB"
    return following in _OBJECTS or (is_phrasal and words[position + 2].said in _OBJECTS)


def _is_complete(words: Sequence[TaggedWord]) -> bool:
    """Whether words can end where a command begins."""
    last = words[-1]
    before = words[-2] if len(words) > 1 else last
    if last.said in _OPEN | _SUBJECTS | _OBJECTS - {"it", "them", "me", "him", "us"}:
        return False
    if not any(word.upos == "VERB" or word.said in _BE for word in words):
        return False
    if any(word.said in _WITH_A_VERB and word.upos == "VERB" for word in words):
        return False
    is_predicate = last.upos == "ADJ" and before.said in _BE
    # "I want to sleep turn off the light"; "I want to go get the mug" goes on.
    is_infinitive = last.upos == "VERB" and before.said == "to" and last.said not in _LEADING
    is_particle = last.upos == "ADP" and last.said in _PARTICLES and before.upos != "VERB"
    return last.upos in _COMPLETE or is_predicate or is_infinitive or is_particle


def joined(text: str, trees: Sequence[DependencyTree]) -> DependencyTree:
    """Return one tree of the trees of an utterance's parts, in which each hangs beside the first."""
    words: List[Word] = []
    first = 0
    for tree in trees:
        shift = len(words)
        for word in tree.words:
            head = word.head + shift if word.head else first
            words.append(
                replace(
                    word,
                    index=word.index + shift,
                    head=head,
                    deprel=word.deprel if word.head or not first else "parataxis",
                )
            )
        first = first or next(word.index for word in words if word.head == 0)
    return DependencyTree(text=text, words=tuple(words))


def parts(text: str, positions: Sequence[int]) -> List[Tuple[int, int]]:
    """Return where each part of a text begins and ends, blanks at its end left out."""
    bounds = [0, *positions, len(text)]
    return [(start, start + len(text[start:end].rstrip())) for start, end in zip(bounds, bounds[1:])]
