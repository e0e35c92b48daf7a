"""Finds the words around a command: "could you please ...", "I was wondering if you could ...", "..., robot".

Commands are rare in the text that the parser learned from, so it parses a command better without the words around it.
The parser receives the command alone; then these words, whose analysis is known, are added to its tree. They become
*asides* of the verb, but in "could you" the modal becomes the auxiliary of the verb, and "you" its subject.
"""

import re
from dataclasses import dataclass
from typing import AbstractSet, Dict, Iterable, Mapping, Optional, Sequence, Tuple

from semantic_types.parts_of_speech import VERB, base_forms
from utterance_passes.engine.utterance_pass import Example, Kind, Surroundings, surroundings_pass
from utterance_passes.trees.formula_file import pattern_of, without_padding
from utterance_passes.trees.spelling import Spelling
from utterance_passes.trees.tree import ASIDE
from utterance_passes.trees.tree_edits import WordAround
from utterance_passes.trees.vocabulary import OBJECT_BEGINNINGS, Verbs, Vocabulary
from word_classes import word_class

_OPENINGS = pattern_of("openings")
_MODAL = pattern_of("modal_openings")
_MINDING = pattern_of("gerund_openings")
_POLITE = pattern_of("anywhere")
_APART = pattern_of("apart")
_TAILS = pattern_of("tails")
_SET_OFF_TAILS = pattern_of("set_off_tails")
_DOUBTING = word_class("habitual_adverbs")
_FORMS_OF_BE = word_class("forms_of_be")
_JOINING = frozenset(["and", "or"])
_LEAD_IN = word_class("lead_in")
_NO_COMMANDS = word_class("nonfinite_forms_of_be") | word_class("forms_of_have") | word_class("forms_of_do")
_NOT = word_class("not")
_PADDING = word_class("padding")
_SAYING = word_class("saying_verbs")
#: The most words of a formula.
_LONGEST = 14
_MARKS = (".", "?", "!")
#: Marks behind a formula: "do me a favour: open the door", "good job! Open the door".
_BREAKS = (",", ":", ".", "!")
#: Ends of formulas behind which the verb may have any form: "it would be great if you *opened* the door".
_SUPPOSING = (" if you", " rather you", " rather that you")
_TOKEN = re.compile(r"\w+?(?=n't\b)|n't\b|'\w\w?\b|[\w-]+|[^\w\s]")
#: Parts of speech by relation; the other words around a command are interjections.
_TAGS: Dict[str, Tuple[str, str]] = {"aux": ("AUX", "MD"), "nsubj": ("PRON", "PRP"), "vocative": ("NOUN", "NN")}


@dataclass(frozen=True)
class _Token:
    form: str
    start: int
    end: int

    @property
    def said(self) -> str:
        return self.form.lower()


@dataclass(frozen=True)
class _Front:
    """The position of the verb of a command, its base form, and the relations of the formula words before it."""

    verb: int
    base: str
    relations: Mapping[int, str]


@surroundings_pass(
    Kind.REPAIR,
    Example(
        "robot, could you turn left please",
        ("turn left", "robot: vocative", ",: punct", "could: aux", "you: nsubj", "please: discourse:aside"),
        Verbs(frozenset(["turn"])),
    ),
)
def surroundings(spelling: Spelling, vocabulary: Vocabulary) -> Optional[Surroundings]:
    """Parse a command without the words around it: "could you ..., please".

    Args:
        spelling: spelling of the utterance
        vocabulary: known verbs
    Returns:
        the command and the words around it; None if there are no such words, or no known verb begins the command
    """
    tokens = [_Token(match.group(), *match.span()) for match in _TOKEN.finditer(spelling.text)]
    front = _front(tokens, 0, vocabulary)
    if front is None:
        return None
    verb = front.verb
    # "Please" and "thanks" may be part of the message: "say yes, please".
    end = _end(tokens, verb + (3 if front.base in _SAYING else 2))
    inside = _inside(tokens, verb, end)
    if not verb and inside is None and end == len(tokens) - (tokens[-1].form in _MARKS):
        return None
    before = [_word(token, spelling, front.relations.get(number, "")) for number, token in enumerate(tokens[:verb])]
    behind = [_word(token, spelling, "" if token.said == "robot" else ASIDE) for token in tokens[end:]]
    start, stop = inside if inside is not None else (end, end)
    between = [_word(token, spelling, ASIDE) for token in tokens[start:stop]]
    ranges = ((tokens[verb].end, tokens[start - 1].end), (tokens[stop - 1].end, tokens[end - 1].end))
    command = _command(spelling, tokens[verb], front.base, ranges)
    return Surroundings(command, tokens[verb].form, front.base, tuple(before + between + behind))


def _front(
    tokens: Sequence[_Token], start: int, vocabulary: Vocabulary, *, ending: Optional[str] = None
) -> Optional[_Front]:
    """Find the verb of a command after any number of formulas.

    Args:
        tokens: of the utterance
        start: where to look
        vocabulary: known verbs
        ending: of the form of the verb, any for ""; None: it has its base form
    """
    first = _behind(tokens, start, _LEAD_IN | _PADDING)
    for behind in range(min(len(tokens), first + _LONGEST), first, -1):
        forms = [token.said for token in tokens[first:behind]]
        if forms[-1] in _PADDING or forms[-1] in _BREAKS:
            continue
        text = without_padding(forms)
        is_modal, minds = _MODAL.fullmatch(text) is not None, _MINDING.fullmatch(text) is not None
        following = tokens[behind].said if behind < len(tokens) else ""
        if is_modal and following in _DOUBTING:
            return None
        if following in _JOINING and not _NOT.isdisjoint(forms):
            continue  # "Don't panic and run" forbids both.
        is_formula = is_modal or minds or _OPENINGS.fullmatch(text) or _POLITE.fullmatch(text)
        inflected = "ing" if minds else "" if text.endswith(_SUPPOSING) else None
        found = _front(tokens, behind, vocabulary, ending=inflected) if is_formula else None
        if found is not None and not (is_modal and found.relations):
            relations = {
                number: ("nsubj" if tokens[number].said == "you" else "aux") if is_modal else ASIDE
                for number in range(first, behind)
                if tokens[number].said not in _PADDING
            }
            return _Front(found.verb, found.base, {**relations, **found.relations})
    # "Let" and "hurry" can be verbs of a command, but not in "let's turn left" and "hurry up and turn left".
    base = _base(tokens, first, vocabulary, ending)
    return _Front(first, base, {}) if base else None


def _behind(tokens: Sequence[_Token], position: int, skipped: AbstractSet[str]) -> int:
    while position < len(tokens) and (tokens[position].said in skipped or tokens[position].form in _BREAKS):
        position += 1
    return position


def _base(tokens: Sequence[_Token], verb: int, vocabulary: Vocabulary, ending: Optional[str]) -> str:
    """Return the base form of the verb of a command; empty if there is no known verb at that position."""
    form = tokens[verb].said if verb < len(tokens) else ""
    following = tokens[verb + 1].said if verb + 1 < len(tokens) else ""
    # "Name is Bob" is not a command, and "could you have opened it" is not a request.
    is_auxiliary = form in _NO_COMMANDS and following not in OBJECT_BEGINNINGS
    if not form or is_auxiliary or following in _FORMS_OF_BE:
        return ""
    if ending is None:
        return form if vocabulary.verbs_beginning_with(form) else ""
    forms = base_forms(form, VERB) if form.endswith(ending) else ()
    return next((base for base in forms if vocabulary.verbs_beginning_with(base)), "")


def _end(tokens: Sequence[_Token], earliest: int) -> int:
    """Return the position after the last word of the command."""
    last = len(tokens) - (tokens[-1].form in _MARKS)
    for end in range(earliest, last):
        is_set_off = tokens[end].form == ","
        said = " ".join(token.said for token in tokens[end + is_set_off : last])
        if _TAILS.fullmatch(said) or (is_set_off and _SET_OFF_TAILS.fullmatch(said)):
            return end
    return last


def _inside(tokens: Sequence[_Token], verb: int, end: int) -> Optional[Tuple[int, int]]:
    """Find a formula between two commas behind the verb or its first object: "bring me, *if you can*, the cup".

    Args:
        tokens: of the utterance
        verb: position of the verb
        end: the position after the last word of the command
    Returns:
        the positions of its first comma and after its last comma
    """
    commas = [number for number in range(verb + 1, end) if tokens[number].form == ","][:2]
    if len(commas) < 2 or commas[0] > verb + 2:
        return None
    said = " ".join(token.said for token in tokens[commas[0] + 1 : commas[1]])
    is_formula = any(formula.fullmatch(said) for formula in (_TAILS, _POLITE, _APART))
    return (commas[0], commas[1] + 1) if is_formula else None


def _command(spelling: Spelling, verb: _Token, base: str, ranges: Iterable[Tuple[int, int]]) -> Spelling:
    """Return the command alone, written as a plain command, with a mark if the utterance ends with one.

    Args:
        spelling: of the utterance
        verb: its verb
        base: the base form of that
        ranges: of the characters that belong to the command, behind its verb
    """
    written = base[0].upper() + base[1:] if spelling.text[:1].isupper() else base
    origins = (spelling.origins[verb.start],) * len(base)
    for start, stop in ranges:
        written += spelling.text[start:stop]
        origins += spelling.origins[start:stop]
    mark = "." if spelling.text[-1:] in _MARKS else ""
    return Spelling(written + mark, origins + (spelling.origins[stop],) * (1 + len(mark)))


def _word(token: _Token, spelling: Spelling, relation: str) -> WordAround:
    said = token.said
    upos, xpos = _TAGS.get(relation, ("INTJ", "UH"))
    if re.fullmatch(r"\W", said):
        upos, xpos, relation = "PUNCT", "." if said in _MARKS else ",", "punct"
    elif not relation and said == "robot":
        upos, xpos, relation = "NOUN", "NN", "vocative"
    elif not relation:
        relation = ASIDE if said in _PADDING and said != "please" else "discourse"
    start, end = spelling.origins[token.start], spelling.origins[token.end]
    return WordAround(token.form, upos, xpos, relation, start, end)
